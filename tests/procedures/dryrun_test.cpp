// SPDX-License-Identifier: GPL-3.0-or-later
// A dry run predicts what a run does: it is compared with the same sequence run on the bench's chain.
#include "link/dryrun/dryrun.h"

#include <gmock/gmock.h>

#include "tests/procedures/sequencebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

class DryRuns : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(bench.ready()); }
    DryRun dry(const std::string& sequence, std::size_t row = 0) {
        bench.take();
        return dryRun({.machine = bench.machine,
                       .modules = bench.modules,
                       .sequence = sequence,
                       .row = row,
                       .longest = longest},
                      cancelled);
    }
    SequenceBench bench;
    std::atomic<bool> cancelled = false;
    double longest = kLongestDryRun;
};

TEST_F(DryRuns, TakeAsLongAndGoAsFarAsTheRun) {
    // Begin at a position other than 0.
    bench.run = SequenceRun::toPoint(bench.machine, "A");
    ASSERT_EQ(bench.goOn().stage, SequenceStage::Done);
    bench.modules[0].home.found(100, bench.modules[0].latestTime);
    const DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.done());
    const TimePoint began = bench.bus.now;
    const auto shafts = bench.shafts();
    bench.start("Main");
    ASSERT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_NEAR(foreseen.seconds, toSeconds(bench.bus.now - began), 0.5);
    ASSERT_EQ(foreseen.axes.size(), 3U);
    // X moves from 1 000 to 1 100, then to 100, and back to 1 100.
    EXPECT_NEAR(foreseen.axes[0].lowest, 100, 10);
    EXPECT_NEAR(foreseen.axes[0].highest, 1'100, 10);
    EXPECT_NEAR(foreseen.axes[0].travelled, 100 + 1'000 + 1'000, 50);
    EXPECT_EQ(foreseen.axes[0].moves, 3U);
    EXPECT_EQ(foreseen.axes[2].lowest, 0);
    EXPECT_EQ(foreseen.axes[2].highest, 200);
    EXPECT_EQ(foreseen.axes[2].travelled, 400);
    EXPECT_NE(bench.shafts(), shafts) << "the run itself moved the shafts";
}

/// X approaches from below: on its way back from 1 000 to 0 it turns round at -50.
TEST_F(DryRuns, TurnRoundWhereTheRunDoes) {
    bench.modules[0].backlash = {50, false};
    bench.machine.program.sequences = {{"Main", {action::MoveTo{"A"}, action::MoveTo{"B"}}},
                                       {"Stay", {action::MoveTo{"B"}}}};
    DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.done());
    EXPECT_NEAR(foreseen.axes[0].lowest, -50, 10);
    EXPECT_NEAR(foreseen.axes[0].highest, 1'000, 10);
    EXPECT_EQ(foreseen.axes[0].moves, 3U);
    const TimePoint began = bench.bus.now;
    bench.start("Main");
    ASSERT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_NEAR(foreseen.seconds, toSeconds(bench.bus.now - began), 0.5);

    bench.modules[0].travel.lowest = -49;
    foreseen = dry("Main");
    ASSERT_EQ(foreseen.problems.size(), 1U);
    EXPECT_EQ(foreseen.problems[0].refusal, Refusal::BeyondTravel);
    EXPECT_EQ(foreseen.problems[0].row, 1U);

    ASSERT_EQ(bench.modules[0].goal(), 0);
    bench.modules[0].latest->position = 1;  // friction keeps it from its goal
    foreseen = dry("Stay");
    ASSERT_TRUE(foreseen.done());
    EXPECT_EQ(foreseen.axes.at(0).moves, 1U);
}

TEST_F(DryRuns, MoveNothing) {
    const std::size_t before = bench.bus.sent.size();
    const auto shafts = bench.shafts();
    ASSERT_TRUE(dry("Main").done());
    EXPECT_EQ(bench.bus.sent.size(), before);
    EXPECT_EQ(bench.shafts(), shafts);
}

TEST_F(DryRuns, SayWhatIsRefusedAndWhere) {
    bench.machine.program.points[0].axes[0].counts = 0x7FFFFFFF;
    bench.modules[0].home.found(1, bench.modules[0].latestTime);
    DryRun foreseen = dry("Main");
    ASSERT_FALSE(foreseen.problems.empty());
    EXPECT_EQ(foreseen.problems[0].refusal, Refusal::GoalOutOfRange);
    EXPECT_EQ(foreseen.problems[0].row, 0U);
    // Some refusals show only during the run: here a stepper is at its limit when it is to move on.
    bench.machine.program.points = {{"A", {{kTable, 200}}}, {"B", {{kTable, 100}}}};
    bench.machine.program.sequences = {
        {"Main",
         {action::MoveTo{"A"}, action::WaitForInput{kTable, InputPin::Limit2, true, 5},
          action::MoveTo{"B"}}}};
    foreseen = dry("Main");
    EXPECT_TRUE(foreseen.inputsAssumed);
    EXPECT_EQ(foreseen.report.end, SequenceEnd::Refused);
    EXPECT_EQ(foreseen.report.refusal, Refusal::Limit2Active);
    EXPECT_EQ(foreseen.report.places[0].row, 2U);
}

/// A servo that is on with gains that this panel does not know, as after attaching, can run the sequence. The
/// copy cannot be switched on without them.
TEST_F(DryRuns, SayWhichMotorCannotBeSimulated) {
    bench.modules[0].doubtGains();
    DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.problems.empty()) << "it would start";
    EXPECT_FALSE(foreseen.done());
    EXPECT_EQ(foreseen.report.module, kX);
    EXPECT_EQ(foreseen.leftOff, Refusal::GainsUnknown);
    bench.machine.program.points = {{"A", {{kY, -500}}}};
    bench.machine.program.sequences = {{"Main", {action::MoveTo{"A"}}}};
    foreseen = dry("Main");
    EXPECT_TRUE(foreseen.done()) << "it does not need that motor";
    EXPECT_EQ(foreseen.leftOff, std::nullopt);
}

TEST_F(DryRuns, DoForEverOnceAndWaitForNoInput) {
    bench.machine.program.sequences = {
        {"Main",
         {action::Wait{1.0}, action::WaitForInput{kTable, InputPin::In2, true, 60}, action::Repeat{0, 0}}}};
    const DryRun foreseen = dry("Main");
    EXPECT_TRUE(foreseen.done());
    EXPECT_TRUE(foreseen.onceOnly);
    EXPECT_TRUE(foreseen.inputsAssumed);
    EXPECT_NEAR(foreseen.seconds, 1.0, 0.2);
    EXPECT_TRUE(foreseen.axes.empty());
}

TEST_F(DryRuns, TakeHomeWhereItIsKnown) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.velocity = 100;
    recipe.acceleration = 1'000;
    recipe.travelLimit = recipe.timeLimit = 100;
    bench.machine.axes[2].homing = recipe;
    bench.modules[2].home.found(-80, bench.modules[2].latestTime);
    bench.machine.program.points = {{"A", {{kTable, 200}}}};
    bench.machine.program.sequences = {{"Main", {action::Home{kTable}, action::MoveTo{"A"}}}};
    const DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.done());
    EXPECT_THAT(foreseen.homeAssumed, testing::ElementsAre(kTable));
    ASSERT_EQ(foreseen.axes.size(), 1U);
    EXPECT_EQ(foreseen.axes[0].lowest, -80);
    EXPECT_EQ(foreseen.axes[0].highest, 120);
}

/// IO3 is the only output of the PIC-I/O.
/// The travel limits are in force from the search on.
TEST_F(DryRuns, KeepTheTravelLimitsOfAnAxisThatIsHomedFirst) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.velocity = 100;
    recipe.acceleration = 1'000;
    recipe.travelLimit = recipe.timeLimit = 100;
    bench.machine.axes[2].homing = recipe;
    bench.modules[2].home.forget();
    bench.modules[2].travel.highest = 150;
    bench.machine.program.points = {{"A", {{kTable, 200}}}};
    bench.machine.program.sequences = {{"Main", {action::Home{kTable}, action::MoveTo{"A"}}}};
    const DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.problems.empty());
    EXPECT_EQ(foreseen.report.end, SequenceEnd::Refused);
    EXPECT_EQ(foreseen.report.refusal, Refusal::BeyondTravel);
    EXPECT_EQ(foreseen.report.places.at(0).row, 1U);
}

/// The first pass finds the home that the point was taught without.
TEST_F(DryRuns, ForeseeThatAPointTaughtWithoutHomeIsNotUsedAgain) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.velocity = 100;
    recipe.acceleration = 1'000;
    recipe.travelLimit = recipe.timeLimit = 100;
    bench.machine.axes[2].homing = recipe;
    bench.modules[2].home.forget();
    bench.machine.program.points = {{"A", {{kTable, 200, false}}}};
    bench.machine.program.sequences = {
        {"Main", {action::MoveTo{"A"}, action::Home{kTable}, action::Repeat{0, 2}}}};
    const DryRun foreseen = dry("Main");
    ASSERT_TRUE(foreseen.problems.empty());
    EXPECT_EQ(foreseen.report.end, SequenceEnd::TaughtElsewhere);
    EXPECT_EQ(foreseen.report.places.at(0).row, 0U);
}

TEST_F(DryRuns, DoWhatTheRowsAskOfAPicIo) {
    constexpr ModuleIndex kBox{3};
    ModuleState box;
    box.info = {kBox, BusAddress(4), {ModuleType::Io, 1}};
    StatusReport report;
    report.pins = 0x0001;
    report.analogs = {0, 100, 255};
    box.latest = report;
    box.apply(bus::CommandExecuted{kBox, TimePoint{}, IoCommand(io::SetDirection{0x0FFB})});
    bench.modules.push_back(box);
    bench.machine.program.sequences = {
        {"There", {action::WaitForInput{kBox, InputPin::Io1, true, 5}, action::SetOutput{kBox, 3, true}}},
        {"Not there", {action::WaitForInput{kBox, InputPin::Io12, true, 5}}},
        {"Not above", {action::WaitForAnalog{kBox, 2, true, 100, 5}}}};
    for (const auto& [sequence, rows] : bench.machine.program.sequences) {
        const DryRun foreseen = dryRun({bench.machine, bench.modules, sequence}, cancelled);
        EXPECT_TRUE(foreseen.done()) << sequence;
        EXPECT_EQ(foreseen.inputsAssumed, sequence != "There") << sequence;
        EXPECT_LT(foreseen.seconds, 1.0) << sequence;
    }
    bench.modules.pop_back();
}

/// There is no data sheet for it here, and the simulator does not support it.
TEST_F(DryRuns, LeaveOutAModuleThatIsNotKnownHere) {
    ModuleState other;
    other.info = {ModuleIndex(3), BusAddress(4), {ModuleType::Adc, 1}};
    bench.modules.push_back(other);
    EXPECT_TRUE(dry("Main").done());
    bench.modules.pop_back();
}

TEST_F(DryRuns, EndWhenNobodyWantsThemAnyMore) {
    bench.machine.program.sequences = {{"Main", {action::Wait{86'400}, action::Repeat{0, 1'000'000}}}};
    longest = 60;
    const DryRun longOne = dry("Main");
    EXPECT_TRUE(longOne.tooLong);
    EXPECT_NEAR(longOne.seconds, 60, 1);
    EXPECT_FALSE(longOne.done());
    cancelled = true;
    const DryRun foreseen = dry("Main");
    EXPECT_TRUE(foreseen.cancelled || !foreseen.done());
    EXPECT_LT(foreseen.seconds, 1.0);
}

}  // namespace
}  // namespace nmc::test
