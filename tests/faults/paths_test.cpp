// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the line while points of a path are added: either no point is added twice or left out, or the
// path ends for all its axes, gives the reason, and nothing of it is sent any more. The ends of the procedure
// itself are in tests/procedures/pathends_test.cpp.
#include <sstream>
#include <string>

#include "sim/faultspec.h"
#include "tests/bus/steps.h"
#include "tests/procedures/pathbench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using servo::PathRate;

constexpr std::size_t kPoints = 600;  ///< 10 s

class FaultyPath : public testing::Test {
protected:
    void hold(std::size_t axes = 1) {
        ASSERT_TRUE(bench.hold());
        if (axes > 1) {
            ASSERT_TRUE(bench.group());
        }
        table = bench.swings(PathRate::Hz60, kPoints);
        table.columns.resize(axes);
    }
    /// Injects a fault in the notation of simulator.md.
    void fault(const std::string& line) {
        std::vector<std::string> words;
        std::istringstream stream(line);
        for (std::string word; stream >> word;)
            words.push_back(word);
        const auto spec = sim::parseFault(std::vector<std::string_view>(words.begin(), words.end()), scs(2));
        ASSERT_TRUE(spec.has_value()) << spec.error();
        ASSERT_TRUE(bench.bus.chain.inject(*spec, bench.bus.now).has_value());
    }
    /// Expects that the path was done and on each point, or that it has ended for a reason.
    void expectWholeOrOver(const ProcedureReport& report) {
        std::uint64_t struck = 0;
        for (const sim::FaultReport& strikes : bench.bus.chain.faults())
            struck += strikes.struck;
        EXPECT_GT(struck, 0U);
        if (report.stage == ProcedureStage::Done)
            for (std::uint8_t i = 0; i < table.columns.size(); ++i)
                EXPECT_TRUE(bench.wasOnEachPoint(table, i)) << int{i};
        else
            expectOver();
    }
    void expectOver() {
        const auto last = bench.bus.last<bus::PathProgress>();
        ASSERT_TRUE(last.has_value());
        EXPECT_TRUE(last->end.has_value());
        bench.bus.chain.clearFaults(bench.bus.now);
        bench.bus.runFor(5s);  // owed stops are sent
        const std::size_t since = bench.bus.sent.size();
        for (std::uint8_t i = 0; i < bench.modules.size(); ++i) {
            EXPECT_TRUE(bench.stands(i)) << int{i};
            EXPECT_FALSE(bench.bus.servo(i).later->pathMode) << int{i};
        }
        EXPECT_EQ(bench.frames(since), 0U);
    }

    PathBench bench{scs(2)};
    PathTable table;
};

class FaultyPathLine : public FaultyPath, public testing::WithParamInterface<const char*> {};

TEST_P(FaultyPathLine, AddsEachPointOnceOrEnds) {
    hold();
    bench.follow(table);
    ASSERT_TRUE(bench.runToPoint(60));
    fault(GetParam());
    expectWholeOrOver(bench.goOn());
}
TEST_P(FaultyPathLine, EndsForBothAxesWhereItEnds) {
    hold(2);
    bench.follow(table);
    ASSERT_TRUE(bench.runToPoint(60));
    fault(GetParam());
    expectWholeOrOver(bench.goOn());
}
INSTANTIATE_TEST_SUITE_P(Line, FaultyPathLine,
                         testing::Values("bus drop cmd p=.002", "bus drop status p=.002",
                                         "bus flip cmd p=.002", "bus flip status p=.002",
                                         "bus dup cmd p=.002", "bus dup status p=.002",
                                         "module 1 cksum p=.05", "module 1 silent on=add_path_points n=1",
                                         "module 1 ignore=add_path_points n=1",
                                         "module 1 delay on=add_path_points t=60ms..80ms n=3"));

TEST_F(FaultyPath, AModuleThatFallsSilentEndsItForAll) {
    hold(2);
    bench.follow(table);
    ASSERT_TRUE(bench.runToPoint(60));
    fault("module 2 silent");
    const ProcedureReport report = bench.goOn();
    EXPECT_NE(report.stage, ProcedureStage::Done);
    expectOver();
}

/// The path ends the trial, but the gains from before do not arrive.
TEST_F(FaultyPath, DoesNotBeginWithGainsThatAreStillOnTrial) {
    ASSERT_NO_FATAL_FAILURE(hold());
    const servo::SetGain before{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
    servo::SetGain tried = before;
    tried.kp = 150;
    bench.bus.submit(
        {.id = {}, .orders = {toServo(0, tried)}, .trial = bus::GainTrial{before, 100, 2'000, 60s}});
    ASSERT_TRUE(bench.bus.runUntil([this] { return bench.bus.servo(0).gains.kp == 150; }, 1s));
    bench.bus.onCommand = [](std::vector<std::uint8_t>& command) {
        if (command.size() > 2 && command[1] == 1 && (command[2] & 0x0FU) == 0x06)  // Set Gain
            command.clear();
    };
    const std::size_t since = bench.bus.sent.size();
    EXPECT_NE(bench.runPath(table, 5.0).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.frames(since), 0U);
}

TEST_F(FaultyPath, AStopWhileALineDropsBytesEndsIt) {
    hold(2);
    bench.follow(table);
    ASSERT_TRUE(bench.runToPoint(60));
    fault("bus drop cmd p=.01");
    fault("bus drop status p=.01");
    const auto stopped = bench.bus.stopAll();
    ASSERT_TRUE(stopped.has_value());
    EXPECT_NE(bench.goOn().stage, ProcedureStage::Done);
    expectOver();
}

}  // namespace
}  // namespace nmc::test
