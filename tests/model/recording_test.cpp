// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <clocale>
#include <locale>

#include "recordings.h"
#include "scopesamples.h"

namespace nmc {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using testing::StartsWith;

/// Sets what de_DE does to programs that do not request the C locale; also the system's own locale, where it
/// is installed.
class UnderGermanLocale {
public:
    UnderGermanLocale()
        : m_before(std::locale::global(std::locale(std::locale::classic(), new DecimalComma))) {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"})
            if (std::setlocale(LC_ALL, name) != nullptr)
                break;
    }
    ~UnderGermanLocale() {
        std::setlocale(LC_ALL, "C");
        std::locale::global(m_before);
    }
    UnderGermanLocale(const UnderGermanLocale&) = delete;
    UnderGermanLocale& operator=(const UnderGermanLocale&) = delete;

private:
    struct DecimalComma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::locale m_before;
};

TimePoint atNs(std::int64_t nanoseconds) {
    return TimePoint(Duration(nanoseconds));
}

std::uint32_t bits(float number) {
    return std::bit_cast<std::uint32_t>(number);
}

TEST(Recording, IsWrittenAsDescribedUnderAnyLocale) {
    const UnderGermanLocale german;
    const TimePoint zero = atNs(5'000'000'000);
    RecordingHeader header = recordingHeader();
    header.zero = zero;
    const std::string head = recordingHead(header);
    EXPECT_THAT(head, StartsWith(kRecordingHead));
    EXPECT_TRUE(head.ends_with('\n' + kWrittenColumnLine));

    ScopeSample first = sampleAt(zero - Duration(1), 1'024);
    first.error = 0.5F;
    first.errorLow = 0.0F;
    first.errorHigh = 1.0F;
    first.analog = 17;
    first.status = 9;
    first.aux = 4;
    ScopeSample second = sampleAt(zero + Duration(600'000'001), -2'147'483'647 - 1);
    second.velocity = -12.25F;
    second.analog = 255;
    second.aux = 63;
    second.gapBefore = true;
    std::string rows;
    appendRow(rows, ModuleIndex(0), first, zero);
    appendGains(rows,
                {ModuleIndex(0), atNs(5'500'000'000),
                 servo::SetGain{100, 1'000, 0, 0, 255, 0, 2'000, 1, std::uint8_t{3}}},
                zero);
    appendRow(rows, ModuleIndex(1), second, zero);
    appendNote(rows, "the motors were told to stop", atNs(5'750'000'000), zero);
    EXPECT_EQ(rows, kWrittenRows);
}

TEST(Recording, ARealSessionSaysSo) {
    RecordingHeader header = recordingHeader();
    header.simulated = false;
    EXPECT_THAT(recordingHead(header), HasSubstr("\n# simulated: no\n"));
    EXPECT_FALSE(readRecording(recordingHead(header)).header.simulated);
}

TEST(Recording, HeadLinesStartWithAHashSoThatOtherReadersCanPassThemOver) {
    const std::string head = recordingHead(recordingHeader());
    std::size_t from = 0;
    for (; from < head.size() - kWrittenColumnLine.size(); from = head.find('\n', from) + 1)
        EXPECT_EQ(head[from], '#') << "at byte " << from;
    EXPECT_EQ(head.substr(from), kWrittenColumnLine);
}

TEST(Recording, WhatAModuleIsCalledStaysOnItsLine) {
    RecordingHeader header = recordingHeader();
    header.modules[0].name = "a\n2,1,1\r";
    header.modules[1].name = " Kräfte, \"B\"; #3: x ";
    const auto read = readRecording(recordingHead(header));
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_EQ(read.header.modules[0].name, "a?2,1,1?");
    EXPECT_EQ(read.header.modules[1].name, header.modules[1].name);
    EXPECT_TRUE(read.samples.empty());
}

TEST(Recording, TheHeadIsReadBack) {
    RecordingHeader header = recordingHeader();
    header.modules[0].unit.countsPerUnit = -(0.1 + 0.2);
    header.modules[1].unit = {UnitKind::Own, 1e-6, "inch"};
    header.modules[1].analog.unit = "";
    header.modules[1].identity = {static_cast<ModuleType>(77), 255};
    EXPECT_EQ(readRecording(recordingHead(header)).header, header);
}

TEST(Recording, GainsOfAllKindsAreReadBack) {
    const std::vector<GainsChange> gains{
        {ModuleIndex(0), atNs(-1), servo::SetGain{1, 2, 3, 4, 5, 6, 7, 8, std::nullopt}},
        {ModuleIndex(11), atNs(500), std::nullopt},
        {ModuleIndex(31), atNs(1'234'567'890),
         servo::SetGain{0x7FFF, 0x7FFF, 0x7FFF, 0x7FFF, 255, 255, 0x3FFF, 255, 255}}};
    std::string text = recordingHead(recordingHeader());
    for (const GainsChange& change : gains)
        appendGains(text, change, TimePoint{});
    const auto read = readRecording(text);
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_EQ(read.gains, gains);
}

TEST(Recording, AnyOtherNoteIsNoChangeOfTheGains) {
    std::string text = recordingHead(recordingHeader());
    for (const char* note : {"gains of module 2", "gains of module 2 unknown again", "gains unknown",
                             "gains of module 0 unknown", "the motors were told to stop"})
        appendNote(text, note, atNs(5), TimePoint{});
    const auto read = readRecording(text);
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_TRUE(read.gains.empty());
}

TEST(Recording, OfAHistoryHasItsSamplesAndGainsInTheOrderOfTime) {
    History history(2);
    history.noteGains({ModuleIndex(0), atNs(5), servo::SetGain{1, 2, 3, 4, 5, 6, 7, 8, std::nullopt}});
    history.append(ModuleIndex(1), sampleAt(atNs(10), 100));
    history.append(ModuleIndex(0), sampleAt(atNs(20), 200));
    history.noteGains({ModuleIndex(0), atNs(25), servo::SetGain{9, 2, 3, 4, 5, 6, 7, 8, std::nullopt}});
    history.append(ModuleIndex(1), sampleAt(atNs(30), 300));
    history.noteGains({ModuleIndex(1), atNs(35), servo::SetGain{10, 2, 3, 4, 5, 6, 7, 8, std::nullopt}});
    history.noteGains({ModuleIndex(1), atNs(40), std::nullopt});
    RecordingHeader header = recordingHeader();
    header.zero = atNs(10);
    std::string expected = recordingHead(header);
    expected +=
        "# gains of module 1 at -0.000000005 s: kp 1 kd 2 ki 3 il 4 ol 5 cl 6 el 7 sr 8\n"
        "2,0.000000000,100,,,,,,0,0,0,0,,,\n"
        "1,0.000000010,200,,,,,,0,0,0,0,,,\n"
        "# gains of module 1 at 0.000000015 s: kp 9 kd 2 ki 3 il 4 ol 5 cl 6 el 7 sr 8\n"
        "2,0.000000020,300,,,,,,0,0,0,0,,,\n"
        "# gains of module 2 at 0.000000025 s: kp 10 kd 2 ki 3 il 4 ol 5 cl 6 el 7 sr 8\n"
        "# note at 0.000000030 s: gains of module 2 unknown\n";
    EXPECT_EQ(recordingOf(header, history), expected);
}

// ---- arbitrary samples ----

/// Any number except the infinities, which nothing measures; every NaN becomes the one that means unknown.
rc::Gen<float> anyFloat() {
    return rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t pattern) {
        const float number = std::bit_cast<float>(pattern);
        return std::isfinite(number) ? number : ScopeSample::kUnknown;
    });
}

rc::Gen<ScopeSample> anySample() {
    using std::chrono::nanoseconds;
    constexpr std::int64_t kYear = 31'536'000'000'000'000;
    const auto withGap = [](ScopeSample sample, bool gap) {
        sample.gapBefore = gap;
        return sample;
    };
    return rc::gen::apply(
        withGap,
        rc::gen::build<ScopeSample>(
            rc::gen::set(&ScopeSample::time,
                         rc::gen::map(rc::gen::inRange<std::int64_t>(-kYear, kYear), atNs)),
            rc::gen::set(&ScopeSample::position, rc::gen::arbitrary<std::int32_t>()),
            rc::gen::set(&ScopeSample::error, anyFloat()), rc::gen::set(&ScopeSample::errorLow, anyFloat()),
            rc::gen::set(&ScopeSample::errorHigh, anyFloat()),
            rc::gen::set(&ScopeSample::velocity, anyFloat()), rc::gen::set(&ScopeSample::analog),
            rc::gen::set(&ScopeSample::status), rc::gen::set(&ScopeSample::aux)),
        rc::gen::arbitrary<bool>());
}

void requireSame(const ScopeSample& read, const ScopeSample& written, Duration later) {
    RC_ASSERT(read.time == written.time + later);
    RC_ASSERT(read.position == written.position);
    RC_ASSERT(bits(read.error) == bits(written.error));
    RC_ASSERT(bits(read.errorLow) == bits(written.errorLow));
    RC_ASSERT(bits(read.errorHigh) == bits(written.errorHigh));
    RC_ASSERT(bits(read.velocity) == bits(written.velocity));
    RC_ASSERT(read.analog == written.analog);
    RC_ASSERT(read.status == written.status);
    RC_ASSERT(read.aux == written.aux);
    RC_ASSERT(read.gapBefore == written.gapBefore);
}

RC_GTEST_PROP(Recording, AnySamplesAreReadBackToTheLastBitUnderAnyLocale, ()) {
    const UnderGermanLocale german;
    auto samples = *rc::gen::container<std::vector<ScopeSample>>(anySample());
    std::sort(samples.begin(), samples.end(),
              [](const ScopeSample& a, const ScopeSample& b) { return a.time < b.time; });
    const auto module = ModuleIndex(*rc::gen::inRange<std::uint8_t>(0, 255));
    const TimePoint zero = atNs(*rc::gen::inRange<std::int64_t>(-1'000'000'000'000, 1'000'000'000'000));
    std::string text = recordingHead(recordingHeader());
    for (const ScopeSample& sample : samples)
        appendRow(text, module, sample, zero);
    const auto read = readRecording(text, *rc::gen::inRange<std::size_t>(1, 3'000));
    RC_ASSERT(!read.problem.has_value());
    RC_ASSERT(read.samples.size() == samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        RC_ASSERT(read.samples[i].first == module);
        requireSame(read.samples[i].second, samples[i], TimePoint{} - zero);
    }
}

}  // namespace
}  // namespace nmc
