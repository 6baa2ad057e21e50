// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses are read from their file as they were written; from a bad file, nothing is read.
#include "model/machinefile/responsestore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nmc {
namespace {

[[nodiscard]] KeptResponse runOf(int number) {
    KeptResponse kept;
    kept.number = number;
    kept.startedAt = "2026-11-21T21:21:02." + std::to_string(100 + number) + "+01:00";
    kept.moduleName = "Module 2 \"X axis\"";
    kept.axisName = "X axis";
    kept.port = "/dev/ttyUSB0";
    kept.scale = AxisScale::servo({UnitKind::Own, 0.1, "µm"}, 2);
    kept.run.module = ModuleIndex(1);
    kept.run.taken = {TimePoint{},
                      -500,
                      600,
                      0.75,
                      ResponseMethod::StopHere,
                      servo::SetGain{200, 2'000, 20, 200, 255, 0, 4'000, 2, std::uint8_t{3}}};
    kept.run.pwm = PwmDemand{300, 255};
    for (int i = -20; i < 700; ++i)
        kept.run.points.push_back({i / 999.7, i < 5 ? -500.0 : 600.0 - i % 2});
    judge(kept.run, kFirstBand);
    return kept;
}

[[nodiscard]] KeptResponse moveOf(int number) {
    KeptResponse kept = runOf(number);
    ResponseTaken& taken = kept.run.taken;
    taken.method = ResponseMethod::Move;
    taken.pace = {CountsPerTick(123'456), CountsPerTickSquared(789)};
    taken.round = 3;
    kept.run.pwm.reset();
    for (ResponsePoint& point : kept.run.points)
        point.error = 0.125 - point.seconds;
    judge(kept.run, kFirstBand);
    return kept;
}

[[nodiscard]] std::vector<int> numbersOf(const std::vector<KeptResponse>& runs) {
    std::vector<int> numbers;
    for (const KeptResponse& run : runs)
        numbers.push_back(run.number);
    return numbers;
}

[[nodiscard]] std::string replaced(std::string text, std::string_view what, std::string_view by) {
    const std::size_t place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return text.replace(place, what.size(), by);
}

TEST(ResponseStore, GivesTheSameRunsAgain) {
    KeptResponse named = runOf(7);
    named.name = "stiffer; \"zäh\"";
    named.note = "with the belt, tight\tand oiled";
    KeptResponse plain = runOf(9);
    plain.run.pwm.reset();
    plain.run.taken.gains.db.reset();
    plain.simulated = true;
    const auto read = readResponses(writeResponses(std::vector{named, plain}));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 2U);
    const KeptResponse& first = read->front();
    EXPECT_EQ(first.number, 7);
    EXPECT_EQ(first.name, named.name);
    EXPECT_EQ(first.note, "with the belt, tight and oiled") << "it is made one line";
    EXPECT_EQ(first.startedAt, named.startedAt);
    EXPECT_EQ(first.moduleName, named.moduleName);
    EXPECT_EQ(first.axisName, "X axis");
    EXPECT_EQ(first.port, named.port);
    EXPECT_EQ(first.scale, named.scale);
    EXPECT_TRUE(first.earlier);
    EXPECT_FALSE(first.simulated);
    EXPECT_EQ(first.run.module, ModuleIndex(1));
    EXPECT_EQ(first.run.taken, named.run.taken);
    EXPECT_EQ(first.run.pwm, named.run.pwm);
    ASSERT_EQ(first.run.points.size(), 720U);
    for (std::size_t i = 0; i < 720; ++i) {
        EXPECT_EQ(first.run.points[i].seconds, named.run.points[i].seconds);
        EXPECT_EQ(first.run.points[i].position, named.run.points[i].position);
    }
    ASSERT_TRUE(first.run.metrics.settling);
    EXPECT_EQ(first.run.metrics.settling->value, named.run.metrics.settling->value);
    EXPECT_FALSE((*read)[1].run.pwm);
    EXPECT_FALSE((*read)[1].run.taken.gains.db);
    EXPECT_TRUE((*read)[1].simulated);
    EXPECT_TRUE(readResponses(writeResponses({}))->empty());
}

TEST(ResponseStore, GivesTheSameMovesAgain) {
    const KeptResponse move = moveOf(4);
    const auto read = readResponses(writeResponses(std::vector{move}));
    ASSERT_TRUE(read);
    const ResponseRecord& run = read->front().run;
    EXPECT_EQ(run.taken, move.run.taken);
    ASSERT_EQ(run.points.size(), move.run.points.size());
    for (std::size_t i = 0; i < run.points.size(); ++i)
        EXPECT_EQ(run.points[i].error, move.run.points[i].error);
    ASSERT_TRUE(run.move && run.move->rms);
    EXPECT_EQ(run.move->rms->value, move.run.move->rms->value);
}

TEST(ResponseStore, SaysWhatIsWrongInABadFile) {
    using Kind = FileProblem::Kind;
    const std::string good = writeResponses(std::vector{runOf(1), runOf(2)});
    const auto problem = [](const std::string& text) {
        const auto read = readResponses(text);
        EXPECT_FALSE(read);
        return read ? FileProblem{} : read.error();
    };
    EXPECT_EQ(problem("").kind, Kind::Empty);
    EXPECT_EQ(problem(good.substr(0, good.size() / 2)).kind, Kind::Truncated);
    EXPECT_EQ(problem(replaced(good, "nmc-panel-step-runs", "nmc-panel-machine")).kind, Kind::OtherFormat);
    const FileProblem newer = problem(replaced(good, "\"version\": 1", "\"version\": 2"));
    EXPECT_EQ(newer.kind, Kind::NewerVersion);
    EXPECT_EQ(newer.found, "2");
    const FileProblem kp = problem(replaced(good, "\"Kp\": 200", "\"Kp\": 40000"));
    EXPECT_EQ(kp.kind, Kind::OutOfRange);
    EXPECT_EQ(kp.field, "Kp");
    EXPECT_GT(kp.line, 10);
    EXPECT_EQ(problem(replaced(good, "600", "-500")).field, "goal_counts") << "no step at all";
    EXPECT_EQ(problem(replaced(good, " 600 ", " 6OO ")).kind, Kind::NotANumber);
    EXPECT_EQ(problem(replaced(good, " 600 ", " inf ")).found, "inf");
    EXPECT_EQ(problem(replaced(good, "\"module\": 2", "\"module\": 0")).kind, Kind::OutOfRange);
    EXPECT_EQ(problem(replaced(good, "\"way\"", "\"weg\"")).kind, Kind::Missing);
    EXPECT_EQ(problem(std::string(kMaxRunFile + 1, ' ')).kind, Kind::TooLarge);
}

TEST(ResponseStore, HasRoomForAHundredOfTheLongest) {
    std::vector<KeptResponse> runs;
    KeptResponse longest = moveOf(1);
    longest.run.taken.record = 6.0;
    longest.run.points.clear();
    // A status about every 0.5 ms, with awkward times.
    for (int i = 0; i < 12'000; ++i)
        longest.run.points.push_back({i / 1'999.9, -123'456'789.0 + i, -1'234.567});
    for (int i = 1; i <= 100; ++i) {
        longest.number = i;
        runs.push_back(longest);
    }
    const std::string text = writeResponses(runs);
    EXPECT_LT(text.size(), kMaxRunFile);
    EXPECT_TRUE(readResponses(text));
}

TEST(ResponseStore, TwoSessionsLoseNothingToEachOther) {
    KeptResponse renamed = runOf(1);
    renamed.name = "mine";
    KeptResponse another = runOf(2);  // has the same number as one of ours
    another.port = "simulator";
    const std::vector<KeptResponse> all =
        together({renamed, runOf(2)}, {runOf(1), another, runOf(3), runOf(4)}, {idOf(runOf(3))});
    EXPECT_THAT(numbersOf(all), testing::ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(all[0].name, "mine");
    EXPECT_EQ(all[2].port, "simulator") << "2 is taken; the run 3 was removed";
    EXPECT_TRUE(together({}, {runOf(1)}, {idOf(runOf(1))}).empty());
}

TEST(ResponseStore, KeepsAHundredAndWhatSomebodyHasNamedLongest) {
    std::vector<KeptResponse> runs;
    for (int i = 1; i <= 104; ++i)
        runs.push_back(runOf(i));
    runs[0].name = "first";
    runs[2].note = "third";
    dropOldest(runs, [](const KeptResponse& run) { return run.number == 4; });
    ASSERT_EQ(runs.size(), 100U);
    runs.resize(4);
    EXPECT_THAT(numbersOf(runs), testing::ElementsAre(1, 3, 4, 8));
    std::vector<KeptResponse> named;
    for (int i = 1; i <= 101; ++i) {
        named.push_back(runOf(i));
        named.back().name = "a name";
    }
    dropOldest(named);
    EXPECT_EQ(named.size(), 100U);
    EXPECT_EQ(named.front().number, 2);
}

}  // namespace
}  // namespace nmc
