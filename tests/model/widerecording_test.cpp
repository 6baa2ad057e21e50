// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording/widerecording.h"

#include <gtest/gtest.h>

#include "recordings.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using testing_support::recordingHeader;

[[nodiscard]] ScopeSample sampleAt(Duration time, std::int32_t position, bool gap = false) {
    ScopeSample sample;
    sample.time = TimePoint(time);
    sample.position = position;
    sample.status = 9;
    sample.analog = 8;
    sample.gapBefore = gap;
    return sample;
}

/// Two counts in a millimetre; 0.25 A in an A/D count above -1.5 A.
[[nodiscard]] RecordingHeader header() {
    RecordingHeader head = recordingHeader();
    head.modules[0].unit.countsPerUnit = 2;
    return head;
}

const std::string kNames =
    "time_s,module1_Left_arm/position_mm,module1_Left_arm/velocity_mm_per_s,module1_Left_arm/command_mm,"
    "module1_Left_arm/error_mm,module1_Left_arm/analog_A,module1_Left_arm/status,module2/position_steps,"
    "module2/velocity_steps_per_s,module2/command_steps,module2/error_steps,module2/analog_V,module2/"
    "status\n";

TEST(WideRecording, HasARowForEachReply) {
    History history(3);
    ScopeSample first = sampleAt(10ms, 3);
    first.error = 1;
    first.velocity = -5;
    history.append(ModuleIndex(0), first);
    history.append(ModuleIndex(1), sampleAt(11ms, 100));
    history.append(ModuleIndex(0), sampleAt(12ms, 5));
    EXPECT_EQ(wideRecordingOf(header(), history), kNames +
                                                      "0.010000000,1.5,-2.5,2,0.5,0.5,9,,,,,,\n"
                                                      "0.011000000,,,,,,,100,,,,4,9\n"
                                                      "0.012000000,2.5,,,,0.5,9,,,,,,\n")
        << "a module without samples has no columns";
}

TEST(WideRecording, IsEvenWhereAnIntervalIsAskedFor) {
    History history(2);
    history.append(ModuleIndex(0), sampleAt(9500us, 0));
    history.append(ModuleIndex(0), sampleAt(12500us, 30));
    history.append(ModuleIndex(0), sampleAt(15500us, 60, true));
    history.append(ModuleIndex(0), sampleAt(17ms, 60));
    history.append(ModuleIndex(1), sampleAt(12ms, 100));
    // 10 counts a millisecond: after 10 ms 5 counts, so 2.5 mm; nothing across the gap from 12.5 to 15.5 ms.
    EXPECT_EQ(wideRecordingOf(header(), history, Duration(1ms)), kNames +
                                                                     "0.010000000,2.5,,,,0.5,9,,,,,,\n"
                                                                     "0.011000000,7.5,,,,0.5,9,,,,,,\n"
                                                                     "0.012000000,12.5,,,,0.5,9,100,,,,4,9\n"
                                                                     "0.013000000,,,,,,,,,,,,\n"
                                                                     "0.014000000,,,,,,,,,,,,\n"
                                                                     "0.015000000,,,,,,,,,,,,\n"
                                                                     "0.016000000,30,,,,0.5,9,,,,,,\n"
                                                                     "0.017000000,30,,,,0.5,9,,,,,,\n");
}

TEST(WideRecording, CountsItsTimesAsTheLongFormDoes) {
    History history(2);
    history.append(ModuleIndex(0), sampleAt(2s, 0));
    RecordingHeader head = header();
    head.zero = TimePoint(2500ms);
    const std::string wide = wideRecordingOf(head, history);
    const std::string longForm = recordingOf(head, history);
    EXPECT_NE(wide.find("\n-0.500000000,0,"), std::string::npos) << wide;
    EXPECT_NE(longForm.find("\n1,-0.500000000,0,"), std::string::npos);
}

TEST(WideRecording, ItsNamesTearNoTable) {
    History history(1);
    history.append(ModuleIndex(0), sampleAt(0ms, 0));
    RecordingHeader head = header();
    head.modules[0].name = "X, \"left\"/right\n";
    head.modules[0].unit = {UnitKind::Own, 2, "µm/2"};
    const std::string wide = wideRecordingOf(head, history);
    EXPECT_TRUE(wide.starts_with("time_s,module1_X__left_right_/position_µm_2,")) << wide;
    EXPECT_EQ(std::count(wide.begin(), wide.end(), ','), 12);
    head.modules[0].name = "Module 1 \"X axis\"";
    EXPECT_TRUE(wideRecordingOf(head, history).starts_with("time_s,Module_1_X_axis/position_µm_2,"));
    EXPECT_EQ(std::count(wide.begin(), wide.end(), '\n'), 2);
}

TEST(WideRecording, OfNothingIsTheTimeAlone) {
    EXPECT_EQ(wideRecordingOf(header(), History(2)), "time_s\n");
    EXPECT_EQ(wideRecordingOf(header(), History(2), Duration(1ms)), "time_s\n");
}

}  // namespace
}  // namespace nmc
