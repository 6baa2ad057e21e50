// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording/recordingreader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recordings.h"

namespace nmc {
namespace {

using namespace testing_support;
using RecordingFault = RecordingProblem::Kind;

std::string allReplaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// A recording with one row below our own columns.
std::string withRow(const std::string& row) {
    return kRecordingHead + kRecordingColumnLine + row;
}
constexpr std::uint64_t kRowLine = 22;

std::optional<RecordingProblem> problemIn(const std::string& text) {
    return readRecording(text).problem;
}

RecordingProblem inLine(std::uint64_t line, RecordingProblem problem) {
    problem.line = line;
    return problem;
}

void expectTheRecording(const ReadRecording& read) {
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_EQ(read.header, recordingHeader());
    ASSERT_EQ(read.samples.size(), 2U);
    const auto& [one, first] = read.samples[0];
    EXPECT_EQ(one, ModuleIndex(0));
    EXPECT_EQ(first.time, TimePoint(Duration(-1)));
    EXPECT_EQ(first.position, 1'024);
    EXPECT_TRUE(std::isnan(first.velocity));
    EXPECT_EQ(first.error, 0.5F);
    EXPECT_EQ(first.errorLow, 0.0F);
    EXPECT_EQ(first.errorHigh, 1.0F);
    EXPECT_EQ(first.analog, 17);
    EXPECT_EQ(first.status, 9);
    EXPECT_EQ(first.aux, 4);
    EXPECT_FALSE(first.gapBefore);
    const auto& [two, second] = read.samples[1];
    EXPECT_EQ(two, ModuleIndex(1));
    EXPECT_EQ(second.time, TimePoint(Duration(600'000'001)));
    EXPECT_EQ(second.position, std::numeric_limits<std::int32_t>::min());
    EXPECT_EQ(second.velocity, -12.25F);
    EXPECT_FALSE(second.errorKnown());
    EXPECT_EQ(second.aux, 63);
    EXPECT_TRUE(second.gapBefore);
    ASSERT_EQ(read.gains.size(), 1U);
    EXPECT_EQ(read.gains[0].time, TimePoint(Duration(500'000'000)));
    EXPECT_EQ(read.gains[0].gains, (servo::SetGain{100, 1'000, 0, 0, 255, 0, 2'000, 1, std::uint8_t{3}}));
}

TEST(RecordingReader, ReadsWhatIsDescribedHoweverItIsCut) {
    for (std::size_t piece = 1; piece < 130; ++piece)
        expectTheRecording(readRecording(kRecording, piece));
    expectTheRecording(readRecording(kRecording, kRecording.size()));
}

TEST(RecordingReader, ReadsWhatAnEditorHasSavedAgain) {
    expectTheRecording(readRecording("\xEF\xBB\xBF" + kRecording));
    expectTheRecording(readRecording(allReplaced(kRecording, "\n", "\r\n")));
    expectTheRecording(readRecording("\xEF\xBB\xBF" + allReplaced(kRecording, "\n", "\r\n\r\n")));
}

/// Like a spreadsheet, gives each line as many cells as the longest one has.
std::string savedAgain(char separator, bool decimalComma) {
    std::string out;
    std::size_t from = 0;
    while (from < kRecording.size()) {
        std::string line = kRecording.substr(from, kRecording.find('\n', from) - from);
        from += line.size() + 1;
        if (line.starts_with('#')) {
            line += std::string(11, separator);
        } else {
            std::replace(line.begin(), line.end(), ',', separator);
            if (decimalComma)
                std::replace(line.begin(), line.end(), '.', ',');
        }
        out += line + "\r\n";
    }
    return out;
}

TEST(RecordingReader, ReadsWhatASpreadsheetHasSavedAgain) {
    expectTheRecording(readRecording(savedAgain(',', false)));
    expectTheRecording(readRecording(savedAgain(';', true)));
    expectTheRecording(readRecording(savedAgain(';', false)));
    expectTheRecording(readRecording(savedAgain('\t', true)));
}

TEST(RecordingReader, ReadsQuotedCellsWithDecimalCommas) {
    const auto read = readRecording(
        "\"# NMC Panel recording 1\",,\n\"# module 1 name: a \"\"b\"\", c\",,\n"
        "\"module\",\"time_s\",\"position\",\"velocity_per_s\"\n1,\"0,5\",\"-3\",\"1,5\"\n");
    EXPECT_FALSE(read.problem.has_value());
    EXPECT_EQ(read.header.modules.at(0).name, "a \"b\", c");
    ASSERT_EQ(read.samples.size(), 1U);
    EXPECT_EQ(read.samples[0].second.time, TimePoint(Duration(500'000'000)));
    EXPECT_EQ(read.samples[0].second.position, -3);
    EXPECT_EQ(read.samples[0].second.velocity, 1.5F);
}

TEST(RecordingReader, FindsColumnsByNameAndPassesOverOthers) {
    const auto read = readRecording(
        "# NMC Panel recording 1\n"
        "gap,mood,position,error,time_s,module,temperature\n"
        "1,good,-5,nan,1E-3,2,21.5\n"
        "0,,6.0,1e-60,1.0000000005,2,#,left over\n");
    EXPECT_FALSE(read.problem.has_value());
    ASSERT_EQ(read.samples.size(), 2U);
    const ScopeSample& first = read.samples[0].second;
    EXPECT_EQ(read.samples[0].first, ModuleIndex(1));
    EXPECT_EQ(first.time, TimePoint(Duration(1'000'000)));
    EXPECT_EQ(first.position, -5);
    EXPECT_TRUE(std::isnan(first.error));
    EXPECT_TRUE(std::isnan(first.errorLow)) << "a missing column means an unknown value";
    EXPECT_TRUE(first.gapBefore);
    EXPECT_EQ(read.samples[1].second.position, 6);
    EXPECT_EQ(read.samples[1].second.error, 0.0F) << "too small for a float";
    EXPECT_EQ(read.samples[1].second.analog, 0);
}

TEST(RecordingReader, SaysThatItIsNoRecording) {
    EXPECT_EQ(problemIn(""), inLine(1, {.kind = RecordingFault::Empty}));
    for (const std::string text :
         {"\x7F"
          "ELF\x02\x01\x01",
          "\n", "PK\x03\x04", "module,time_s,position\n1,2,3\n", "# NMC Panel recording",
          "# NMC Panel recording x\n", "# NMC Panel recording 0\n", "\xFF\xFE#"})
        EXPECT_EQ(problemIn(text), inLine(1, {.kind = RecordingFault::OtherFormat})) << text;
    EXPECT_EQ(problemIn(std::string(3'000'000, '\0')),
              inLine(1, {.kind = RecordingFault::OtherFormat, .max = RecordingReader::kMaxLine}));
}

TEST(RecordingReader, SaysThatItComesFromANewerProgram) {
    const auto newer = inLine(1, {.kind = RecordingFault::NewerVersion, .found = "2", .max = 1});
    EXPECT_EQ(problemIn(allReplaced(kRecording, "recording 1", "recording 2")), newer);
    EXPECT_EQ(problemIn("# NMC Panel recording 2"), newer);
}

TEST(RecordingReader, SaysWhichColumnIsMissing) {
    EXPECT_EQ(problemIn(kRecordingHead), inLine(20, {.kind = RecordingFault::NoColumns}));
    EXPECT_EQ(problemIn(allReplaced(kRecording, "module,", "modul,")),
              inLine(21, {.kind = RecordingFault::MissingColumn, .field = "module"}));
    EXPECT_EQ(problemIn(allReplaced(kRecording, "time_s", "time_ms")),
              inLine(21, {.kind = RecordingFault::MissingColumn, .field = "time_s"}));
    EXPECT_EQ(problemIn(kRecordingHead + "speed\n"),
              inLine(21, {.kind = RecordingFault::MissingColumn, .field = "module"}));
}

TEST(RecordingReader, KeepsWhatIsAboveACutAndTellsOfIt) {
    const auto read = readRecording(kRecording + "1,2.5,1024,,1024.5,0.5,0,1,17,9,4,0");
    EXPECT_EQ(read.samples.size(), 2U);
    EXPECT_EQ(read.problem, inLine(kRowLine + 4, {.kind = RecordingFault::Truncated}));
    EXPECT_EQ(problemIn("# NMC Panel recording 1"), inLine(1, {.kind = RecordingFault::Truncated}));
    for (std::size_t length = 1; length < kRecording.size(); ++length) {
        const std::string text = kRecording.substr(0, length);
        const bool betweenRows = text.ends_with('\n') && length > kRecordingHead.size();
        EXPECT_EQ(problemIn(text).has_value(), !betweenRows) << "cut at byte " << length;
    }
}

TEST(RecordingReader, NothingBelowAProblemIsRead) {
    const auto read = readRecording(withRow("1,1,1,,,,,,0,0,0,0\n1,x,2,,,,,,0,0,0,0\n1,3,3,,,,,,0,0,0,0\n"));
    EXPECT_EQ(read.samples.size(), 1U);
    EXPECT_EQ(read.problem,
              inLine(kRowLine + 1, {.kind = RecordingFault::NotANumber, .field = "time_s", .found = "x"}));
}

TEST(RecordingReader, RefusesWhatIsNoNumber) {
    const auto notANumber = [](const char* field, const char* found) {
        return inLine(kRowLine, {.kind = RecordingFault::NotANumber, .field = field, .found = found});
    };
    EXPECT_EQ(problemIn(withRow("one,1,1,,,,,,0,0,0,0\n")), notANumber("module", "one"));
    EXPECT_EQ(problemIn(withRow("1,nan,1,,,,,,0,0,0,0\n")), notANumber("time_s", "nan"));
    EXPECT_EQ(problemIn(withRow("1,inf,1,,,,,,0,0,0,0\n")), notANumber("time_s", "inf"));
    EXPECT_EQ(problemIn(withRow("1,1,NaN,,,,,,0,0,0,0\n")), notANumber("position", "NaN"));
    EXPECT_EQ(problemIn(withRow("1,1,1.5,,,,,,0,0,0,0\n")), notANumber("position", "1.5"));
    EXPECT_EQ(problemIn(withRow("1,1,1,-inf,,,,,0,0,0,0\n")), notANumber("velocity_per_s", "-inf"));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,0x10,,,0,0,0,0\n")), notANumber("error", "0x10"));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,1 2,,0,0,0,0\n")), notANumber("error_low", "1 2"));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,\x01\xC3\xA4,0,0,0,0\n")), notANumber("error_high", "???"));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,,0,0,0,no\n")), notANumber("gap", "no"));
    EXPECT_EQ(problemIn(withRow("1,1," + std::string(100, '1') + ",,,,,,0,0,0,0\n")),
              notANumber("position", std::string(40, '1').c_str()));
}

TEST(RecordingReader, RefusesWhatNoSampleCanBe) {
    const auto outOfRange = [](const char* field, const char* found, double min, double max) {
        return inLine(
            kRowLine,
            {.kind = RecordingFault::OutOfRange, .field = field, .found = found, .min = min, .max = max});
    };
    constexpr double kTenYears = 315'360'000;
    constexpr auto kFloat = static_cast<double>(std::numeric_limits<float>::max());
    EXPECT_EQ(problemIn(withRow("0,1,1,,,,,,0,0,0,0\n")), outOfRange("module", "0", 1, 255));
    EXPECT_EQ(problemIn(withRow("256,1,1,,,,,,0,0,0,0\n")), outOfRange("module", "256", 1, 255));
    EXPECT_EQ(problemIn(withRow("1,1e300,1,,,,,,0,0,0,0\n")),
              outOfRange("time_s", "1e300", -kTenYears, kTenYears));
    EXPECT_EQ(problemIn(withRow("1,1e999,1,,,,,,0,0,0,0\n")),
              outOfRange("time_s", "1e999", -kTenYears, kTenYears));
    EXPECT_EQ(problemIn(withRow("1,1,2147483648,,,,,,0,0,0,0\n")),
              outOfRange("position", "2147483648", -2'147'483'648.0, 2'147'483'647.0));
    EXPECT_EQ(problemIn(withRow("1,1,1,1e39,,,,,0,0,0,0\n")),
              outOfRange("velocity_per_s", "1e39", -kFloat, kFloat));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,,256,0,0,0\n")), outOfRange("analog", "256", 0, 255));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,,0,-1,0,0\n")), outOfRange("status", "-1", 0, 255));
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,,0,0,0,2\n")), outOfRange("gap", "2", 0, 1));
    EXPECT_EQ(problemIn(allReplaced(kRecording, "counts per unit: 1024.5", "counts per unit: -1e-7")),
              inLine(10, {.kind = RecordingFault::OutOfRange,
                          .field = "module 1 counts per unit",
                          .found = "-1e-7",
                          .min = 1e-6,
                          .max = 1e9}));
    EXPECT_EQ(
        problemIn(allReplaced(kRecording, "analog at zero: -1.5", "analog at zero: nan")),
        inLine(13, {.kind = RecordingFault::NotANumber, .field = "module 1 analog at zero", .found = "nan"}));
}

TEST(RecordingReader, RefusesRowsThatLackCells) {
    EXPECT_EQ(problemIn(withRow("1,1,1,,,,,,0,0,0\n")),
              inLine(kRowLine, {.kind = RecordingFault::TooFewCells, .found = "11", .max = 12}));
    EXPECT_EQ(problemIn(withRow("1,1, ,,,,,,0,0,0,0\n")),
              inLine(kRowLine, {.kind = RecordingFault::EmptyCell, .field = "position"}));
}

TEST(RecordingReader, RefusesTimeThatGoesBackWithinOneModule) {
    EXPECT_EQ(problemIn(withRow("1,2,1,,,,,,0,0,0,0\n2,1,1,,,,,,0,0,0,0\n1,2,1,,,,,,0,0,0,0\n")),
              std::nullopt)
        << "modules answer one after the other";
    EXPECT_EQ(problemIn(withRow("1,2,1,,,,,,0,0,0,0\n1,1.999999999,1,,,,,,0,0,0,0\n")),
              inLine(kRowLine + 1, {.kind = RecordingFault::TimeGoesBack, .field = "time_s", .found = "1"}));
}

TEST(RecordingReader, PositionsMayWrap) {
    const auto read = readRecording(withRow("1,1,2147483647,,,,,,0,0,0,0\n1,2,-2147483648,,,,,,0,0,0,0\n"));
    EXPECT_FALSE(read.problem.has_value());
    ASSERT_EQ(read.samples.size(), 2U);
    EXPECT_EQ(countsBetween(read.samples[0].second.position, read.samples[1].second.position), 1);
}

TEST(RecordingReader, EndsAtALineThatNoRecordingHas) {
    const auto longLine =
        inLine(kRowLine, {.kind = RecordingFault::LineTooLong, .max = RecordingReader::kMaxLine});
    EXPECT_EQ(problemIn(withRow(std::string(5'000'000, '1'))), longLine);
    EXPECT_EQ(problemIn(withRow("# " + std::string(20'000, 'x') + '\n')), longLine);
    EXPECT_EQ(problemIn(withRow(std::string(20'001, ',') + '\n')), longLine);
    EXPECT_EQ(problemIn(withRow("# " + std::string(19'998, 'x') + '\n')), std::nullopt);
}

TEST(RecordingReader, AfterAProblemItWantsNoMore) {
    int taken = 0;
    RecordingReader reader({[&](ModuleIndex, const ScopeSample&) { ++taken; }});
    EXPECT_TRUE(reader.feed(kRecording));
    EXPECT_FALSE(reader.feed("x\n"));
    EXPECT_FALSE(reader.feed("1,5,1,,,,,,0,0,0,0\n"));
    EXPECT_EQ(taken, 2);
    EXPECT_EQ(reader.samples(), 2U);
    EXPECT_EQ(reader.finish()->line, kRowLine + 4);
}

TEST(RecordingReader, WhatOnlyLooksLikeACommentOfOursIsAComment) {
    const auto read =
        readRecording(kRecording +
                      "#\n#gains\n# gains of module 1 at once: kp 5\n"
                      "# gains of module 1 at 1 s: kp 100 kd 1000\n"
                      "# gains of module 1 at 1 s: kp 40000 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1\n"
                      "# gains of module 0 at 1 s: kp 1 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1\n"
                      "# gains of module 1 at 1 s: kp 1 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 3 x\n"
                      "# module 1 name: too late\n# module 300 name: nobody\n");
    expectTheRecording(read);
}

}  // namespace
}  // namespace nmc
