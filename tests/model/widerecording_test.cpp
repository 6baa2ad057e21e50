// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording/widerecording.h"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "recordings.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using testing_support::recordingHeader;

[[nodiscard]] ScopeSample recordedAt(Duration time, std::int32_t position, bool gap = false) {
    ScopeSample sample;
    sample.time = TimePoint(time);
    sample.position = position;
    sample.status = 9;
    sample.analog = 8;
    sample.gapBefore = gap;
    return sample;
}

/// 2 counts per millimetre; 0.25 A per A/D count, from -1.5 A.
[[nodiscard]] RecordingHeader wideHeader() {
    RecordingHeader head = recordingHeader();
    head.modules[0].unit.countsPerUnit = 2;
    return head;
}

/// The contents of recordingHeader(), as column names.
const std::string kAbout =
    ",about/program_NMC_Panel_0.6.0,about/started_2026-11-21T21:21:02.123+01:00,about/port_simulator,"
    "about/simulated_yes_(no_real_motor_moved)";
const std::string kNames =
    "time_s,module1_Left_arm/position_mm,module1_Left_arm/velocity_mm_per_s,module1_Left_arm/command_mm,"
    "module1_Left_arm/error_mm,module1_Left_arm/analog_A,module1_Left_arm/acceleration_mm_per_s2,"
    "module1_Left_arm/pwm_calculated,module1_Left_arm/status,"
    "module2/position_steps,module2/velocity_steps_per_s,module2/command_steps,module2/error_steps,"
    "module2/analog_V,module2/acceleration_steps_per_s2,module2/status" +
    kAbout + '\n';

TEST(WideRecording, HasARowForEachReply) {
    History history(3);
    ScopeSample first = recordedAt(10ms, 3);
    first.error = 1;
    first.velocity = -5;
    history.append(ModuleIndex(0), first);
    history.append(ModuleIndex(1), recordedAt(11ms, 100));
    history.append(ModuleIndex(0), recordedAt(12ms, 5));
    EXPECT_EQ(wideRecordingOf(wideHeader(), history), kNames +
                                                          "0.010000000,1.5,-2.5,2,0.5,0.5,,,9,,,,,,,,,,,\n"
                                                          "0.011000000,,,,,,,,,100,,,,4,,9,,,,\n"
                                                          "0.012000000,2.5,,,,0.5,,,9,,,,,,,,,,,\n")
        << "a module without samples has no columns";
}

TEST(WideRecording, IsEvenWhereAnIntervalIsAskedFor) {
    History history(2);
    history.append(ModuleIndex(0), recordedAt(9500us, 0));
    history.append(ModuleIndex(0), recordedAt(12500us, 30));
    history.append(ModuleIndex(0), recordedAt(15500us, 60, true));
    history.append(ModuleIndex(0), recordedAt(17ms, 60));
    history.append(ModuleIndex(1), recordedAt(12ms, 100));
    // 10 counts a millisecond: 5 counts at 10 ms, which are 2.5 mm; nothing across the gap from 12.5 to 15.5
    // ms.
    EXPECT_EQ(wideRecordingOf(wideHeader(), history, Duration(1ms)),
              kNames +
                  "0.010000000,2.5,,,,0.5,,,9,,,,,,,,,,,\n"
                  "0.011000000,7.5,,,,0.5,,,9,,,,,,,,,,,\n"
                  "0.012000000,12.5,,,,0.5,,,9,100,,,,4,,9,,,,\n"
                  "0.013000000,,,,,,,,,,,,,,,,,,,\n"
                  "0.014000000,,,,,,,,,,,,,,,,,,,\n"
                  "0.015000000,,,,,,,,,,,,,,,,,,,\n"
                  "0.016000000,30,,,,0.5,,,9,,,,,,,,,,,\n"
                  "0.017000000,30,,,,0.5,,,9,,,,,,,,,,,\n");
}

/// PlotJuggler and pandas take the first line for the names, and PlotJuggler refuses a row with fewer or more
/// cells. A comment would be in the way of both.
TEST(WideRecording, SaysWhatItIsInThePlaceThatEveryReaderPassesOver) {
    History history(2);
    history.append(ModuleIndex(0), recordedAt(10ms, 3));
    history.append(ModuleIndex(1), recordedAt(11ms, 4));
    RecordingHeader head = wideHeader();
    head.simulated = false;
    head.port = "/dev/ttyUSB0";
    for (const Duration interval : {Duration::zero(), Duration(1ms)}) {
        const std::string text = wideRecordingOf(head, history, interval);
        EXPECT_TRUE(text.starts_with("time_s,")) << text;
        EXPECT_EQ(text.find('#'), std::string::npos) << text;
        for (const char* const word :
             {",about/program_NMC_Panel_0.6.0,", ",about/started_2026-11-21T21:21:02.123+01:00,",
              ",about/port__dev_ttyUSB0,", ",about/simulated_no\n"})
            EXPECT_NE(text.find(word), std::string::npos) << word << text;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            EXPECT_EQ(std::count(line.begin(), line.end(), ','), 8 + 7 + 4) << line;
    }
}

/// The reader recognises it as our own, so that a user who opens it learns why it cannot be read.
TEST(WideRecording, IsNoRecordingAndTheReaderSaysSo) {
    History history(1);
    history.append(ModuleIndex(0), recordedAt(10ms, 3));
    RecordingReader reader({[](ModuleIndex, const ScopeSample&) { ADD_FAILURE(); }});
    reader.feed(wideRecordingOf(wideHeader(), history));
    EXPECT_EQ(reader.finish(), (RecordingProblem{.kind = RecordingProblem::Kind::OtherForm}));
}

TEST(WideRecording, CountsItsTimesAsTheLongFormDoes) {
    History history(2);
    history.append(ModuleIndex(0), recordedAt(2s, 0));
    RecordingHeader head = wideHeader();
    head.zero = TimePoint(2500ms);
    const std::string wide = wideRecordingOf(head, history);
    const std::string longForm = recordingOf(head, history);
    EXPECT_NE(wide.find("\n-0.500000000,0,"), std::string::npos) << wide;
    EXPECT_NE(longForm.find("\n1,-0.500000000,0,"), std::string::npos);
}

TEST(WideRecording, ItsNamesTearNoTable) {
    History history(1);
    history.append(ModuleIndex(0), recordedAt(0ms, 0));
    RecordingHeader head = wideHeader();
    head.modules[0].name = "X, \"left\"/right\n";
    head.modules[0].unit = {UnitKind::Own, 2, "µm/2"};
    const std::string wide = wideRecordingOf(head, history);
    EXPECT_TRUE(wide.starts_with("time_s,module1_X__left_right_/position_µm_2,")) << wide;
    EXPECT_EQ(std::count(wide.begin(), wide.end(), ','), 24)
        << "8 columns and 4 about the recording, in two lines";
    head.modules[0].name = "Module 1 \"X axis\"";
    EXPECT_TRUE(wideRecordingOf(head, history).starts_with("time_s,Module_1_X_axis/position_µm_2,"));
    EXPECT_EQ(std::count(wide.begin(), wide.end(), '\n'), 2);
}

// ---- derived signals ----

/// Samples of one module every 2 ms, from 0 on; `fill` sets their values.
[[nodiscard]] History everyTwoMs(int count, const std::function<void(int, ScopeSample&)>& fill,
                                 const std::optional<servo::SetGain>& gains = {}, int gainsFrom = 0) {
    History history(1);
    history.noteGains({ModuleIndex(0), TimePoint(2ms * gainsFrom), gains});
    for (int i = 0; i < count; ++i) {
        ScopeSample sample = recordedAt(2ms * i, 0);
        sample.aux = 0x04;  // servo on
        fill(i, sample);
        history.append(ModuleIndex(0), sample);
    }
    return history;
}

/// The cells of a column, row by row; none if there is no such column.
[[nodiscard]] std::vector<std::string> column(const std::string& table, const std::string& name) {
    std::vector<std::string> found;
    std::optional<std::size_t> place;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells(1);
        for (const char c : line)
            c == ',' ? cells.emplace_back() : cells.back() += c;
        if (place)
            found.push_back(cells.at(*place));
        else if (const auto here = std::find(cells.begin(), cells.end(), name); here != cells.end())
            place = static_cast<std::size_t>(here - cells.begin());
        else
            break;
    }
    return found;
}

const std::string kAcceleration = "module1_Left_arm/acceleration_mm_per_s2";
const std::string kPwm = "module1_Left_arm/pwm_calculated";

/// i^3 counts of half a millimetre after i times 2 ms: 3 i / (2 ms)^2. The parabola extends over 40 ms, so
/// the first and the last 20 ms have no value.
TEST(WideRecording, HasTheAccelerationAtEachReply) {
    const History history = everyTwoMs(60, [](int i, ScopeSample& sample) { sample.position = i * i * i; });
    const auto cells = column(wideRecordingOf(wideHeader(), history), kAcceleration);
    ASSERT_EQ(cells.size(), 60U);
    for (int i = 0; i < 60; ++i) {
        const std::string& cell = cells[static_cast<std::size_t>(i)];
        ASSERT_EQ(cell.empty(), i < 10 || i >= 50) << i;
        if (!cell.empty()) {
            EXPECT_NEAR(std::stod(cell), 750'000.0 * i, 10) << i;
        }
    }
}

/// Half-way between two replies, the value is the mean of theirs.
TEST(WideRecording, HasTheAccelerationAtEvenTimes) {
    const History history = everyTwoMs(60, [](int i, ScopeSample& sample) { sample.position = i * i * i; });
    const auto cells = column(wideRecordingOf(wideHeader(), history, Duration(1ms)), kAcceleration);
    ASSERT_EQ(cells.size(), 119U);
    for (int ms = 0; ms < 119; ++ms) {
        const std::string& cell = cells[static_cast<std::size_t>(ms)];
        ASSERT_EQ(cell.empty(), ms < 20 || ms > 98) << ms;
        if (!cell.empty()) {
            EXPECT_NEAR(std::stod(cell), 375'000.0 * ms, 10) << ms;
        }
    }
}

/// i^2 counts every 2.75 ms: 40 ms contain 16 samples, and their middle is between two of them.
TEST(WideRecording, HasTheAccelerationThatLiesBetweenTwoReplies) {
    History history(1);
    for (int i = 0; i < 60; ++i)
        history.append(ModuleIndex(0), recordedAt(2750us * i, i * i));
    const double expected = 2 / (0.00275 * 0.00275) / 2;  // mm/s^2
    const auto cells = column(wideRecordingOf(wideHeader(), history), kAcceleration);
    ASSERT_EQ(cells.size(), 60U);
    EXPECT_EQ(cells[7], "") << "the first value is half an interval later";
    for (std::size_t i = 8; i < 52; ++i)
        EXPECT_NEAR(std::stod(cells[i]), expected, 0.1) << i;
    EXPECT_EQ(cells[52], "");
}

/// Kp * error / 256 of -30 counts is -60; the last value waits for the next reply.
TEST(WideRecording, HasThePwmWhileTheGainsAreKnown) {
    const servo::SetGain gains{512, 0, 0, 0, 255, 0, 16'000, 1, std::uint8_t{0}};
    const auto standing = [](int, ScopeSample& sample) {
        sample.error = sample.errorLow = sample.errorHigh = -30;
    };
    const History history = everyTwoMs(30, standing, gains, 20);
    const std::string sparse = wideRecordingOf(wideHeader(), history);
    std::vector<std::string> expected(30);
    std::fill(expected.begin() + 20, expected.begin() + 29, "-60");
    EXPECT_EQ(column(sparse, kPwm), expected);
    const std::string even = wideRecordingOf(wideHeader(), history, Duration(1ms));
    expected.assign(59, "");
    std::fill(expected.begin() + 40, expected.begin() + 57, "-60");
    EXPECT_EQ(column(even, kPwm), expected);
}

/// 20 counts over 1000 ms / 0.512 ms are more than the IL of 100 allows: the PWM is 100 from then on, as long
/// as the error stays 0. The samples that are written would not suffice to know this.
TEST(WideRecording, MakesThePwmOfWhatWasBeforeToo) {
    const servo::SetGain gains{0, 0, 256, 100, 255, 0, 16'000, 1, std::uint8_t{0}};
    const History history = everyTwoMs(
        1'000,
        [](int i, ScopeSample& sample) {
            sample.error = sample.errorLow = sample.errorHigh = i < 500 ? 20.0F : 0.0F;
        },
        gains);
    const std::string table =
        wideRecordingOf(wideHeader(), history, Duration::zero(), TimePoint(1500ms), TimePoint(1600ms));
    EXPECT_EQ(column(table, kPwm), std::vector<std::string>(51, "100"));
    EXPECT_EQ(column(table, "time_s").front(), "1.500000000");
}

/// 3 counts every 2 ms; the rate is known after the first 100 ms.
TEST(WideRecording, HasTheCountRateOfAPicIo) {
    const History history = everyTwoMs(100, [](int i, ScopeSample& sample) {
        sample.io = sample.counted = true;
        sample.setCounter(static_cast<std::uint32_t>(3 * i));
    });
    RecordingHeader head = wideHeader();
    head.modules[0].identity = {ModuleType::Io, 1};
    for (const Duration interval : {Duration::zero(), Duration(2ms)}) {
        const std::string table = wideRecordingOf(head, history, interval);
        std::vector<std::string> expected(100);
        std::fill(expected.begin() + 50, expected.end(), "1500");
        EXPECT_EQ(column(table, "module1_Left_arm/count_rate_per_s"), expected);
        EXPECT_TRUE(column(table, kAcceleration).empty()) << "it has no motor";
        EXPECT_TRUE(column(table, kPwm).empty());
    }
}

/// The position of module 1 less that of module 2, in half millimetres. Module 2 is at 4, 8 and 12 after 1, 3
/// and 5 ms, so at 6 after 2 ms and at 10 after 4 ms.
TEST(WideRecording, HasWhatTheUserHasDefined) {
    History history(2);
    for (int i = 0; i < 3; ++i) {
        history.append(ModuleIndex(0), recordedAt(2ms * i, 10 + 10 * i));
        history.append(ModuleIndex(1), recordedAt(2ms * i + 1ms, 4 + 4 * i));
    }
    RecordingHeader head = wideHeader();
    head.modules[0].custom = {{"Skew, left",
                               "mm",
                               0.5,
                               {{ModuleIndex(0), ScopeSignal::Custom2},
                                {{ModuleIndex(0), ScopeSignal::Position}},
                                CustomSignal::Part{{ModuleIndex(1), ScopeSignal::Position}, {-1, 0}}}}};
    const std::string sparse = wideRecordingOf(head, history);
    EXPECT_NE(sparse.find("/pwm_calculated,module1_Left_arm/Skew__left_mm,module1_Left_arm/status,module2/"),
              std::string::npos)
        << sparse;
    const std::string kSkew = "module1_Left_arm/Skew__left_mm";
    EXPECT_EQ(column(sparse, kSkew), (std::vector<std::string>{"", "", "7", "", "10", ""}));
    EXPECT_EQ(column(wideRecordingOf(head, history, Duration(1ms)), kSkew),
              (std::vector<std::string>{"", "", "7", "8.5", "10", ""}));
}

TEST(WideRecording, HasNoPwmOfAStepper) {
    History history(2);
    history.append(ModuleIndex(1), recordedAt(0ms, 0));
    const std::string table = wideRecordingOf(wideHeader(), history);
    EXPECT_NE(table.find("module2/acceleration_steps_per_s2"), std::string::npos);
    EXPECT_EQ(table.find("pwm"), std::string::npos);
}

/// More samples than the scope keeps individually for a trace.
TEST(WideRecording, LosesNothingOfALongHistory) {
    constexpr int kCount = 250'000;
    const servo::SetGain gains{256, 0, 0, 0, 255, 0, 16'000, 1, std::uint8_t{0}};
    const History history = everyTwoMs(
        kCount, [](int, ScopeSample& sample) { sample.error = sample.errorLow = sample.errorHigh = 7; },
        gains);
    const std::string table = wideRecordingOf(wideHeader(), history);
    std::vector<std::string> expected(kCount, "7");
    expected.back() = "";
    EXPECT_EQ(column(table, kPwm), expected);
    const auto accelerations = column(table, kAcceleration);
    EXPECT_EQ(std::count(accelerations.begin(), accelerations.end(), "0"), kCount - 20);
}

TEST(WideRecording, OfNothingIsTheTimeAlone) {
    EXPECT_EQ(wideRecordingOf(wideHeader(), History(2)), "time_s" + kAbout + '\n');
    EXPECT_EQ(wideRecordingOf(wideHeader(), History(2), Duration(1ms)), "time_s" + kAbout + '\n');
}

}  // namespace
}  // namespace nmc
