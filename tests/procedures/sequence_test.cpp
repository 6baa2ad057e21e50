// SPDX-License-Identifier: GPL-3.0-or-later
// Sequences in virtual time: engine, simulator and the run, which is driven as the sequence controller
// drives it. Where the motors are is read from the simulator.
#include <gmock/gmock.h>

#include "model/intent/homingplan.h"
#include "tests/procedures/sequencebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;

class Sequences : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(bench.ready()); }
    /// The address and the command of everything since then that loads a motion (05 starts one).
    [[nodiscard]] std::vector<std::string> loadsAndStarts(std::size_t since) {
        std::vector<std::string> order;
        for (std::size_t i = since; i < bench.bus.sent.size(); ++i)
            if (const std::string hex = bench.bus.sent[i].hex(); hex.size() > 8)
                for (const char* start :
                     {"AA 01 05", "AA 02 05", "AA 03 05", "AA 01 D4", "AA 02 D4", "AA 03 74"})
                    if (hex.rfind(start, 0) == 0)
                        order.push_back(hex.substr(3, 5));
        return order;
    }
    /// How many operations the next turn sends; nobody carries them out.
    [[nodiscard]] std::size_t sent() {
        const SequenceRun::Next next = bench.run->next(bench.modules, bench.bus.now);
        const auto* send = std::get_if<SequenceRun::Send>(&next);
        return send != nullptr ? send->operations.size() : 0U;
    }
    SequenceBench bench;
};

/// The goals of the motions of one module, in order.
std::vector<std::int32_t> goalsOf(const SequenceBench& bench, ModuleIndex module) {
    std::vector<std::int32_t> all;
    for (const auto& [index, goal] : bench.goals())
        if (index == module.value())
            all.push_back(goal);
    return all;
}

TEST_F(Sequences, GoesThroughItsRows) {
    ASSERT_THAT(whyNotRun("Main", 0, bench.machine, bench.modules), IsEmpty());
    bench.start("Main");
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.stage, SequenceStage::Done);
    EXPECT_EQ(bench.shafts(), (std::vector<std::int64_t>{1'000, -500, 200}));
    EXPECT_EQ(bench.outputs() & 0x02U, 0U) << "OUT2 was set, and cleared at the end";
    EXPECT_EQ(bench.goals(),
              (std::vector<std::pair<int, std::int32_t>>{
                  {0, 1'000}, {1, -500}, {2, 200}, {0, 0}, {2, 0}, {0, 1'000}, {1, -500}, {2, 200}}));
    bench.bus.expectNoViolations();
}

TEST_F(Sequences, TogetherIsLoadedBeforeAnythingStarts) {
    const std::size_t before = bench.bus.sent.size();
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"A"}}}};
    bench.start("Move");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    const std::vector<std::string> order = loadsAndStarts(before);
    ASSERT_EQ(order.size(), 6U) << testing::PrintToString(order);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(order[i].ends_with("05"), i >= 3) << testing::PrintToString(order);
}

TEST_F(Sequences, OneAfterTheOtherNeverHasTwoMoving) {
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"A", false}}}};
    bench.start("Move");
    int most = 0;
    while (bench.turn())
        most = std::max(most, static_cast<int>(std::ranges::count_if(bench.modules, &ModuleState::moving)));
    EXPECT_EQ(most, 1);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Done);
}

TEST_F(Sequences, RepeatsAndCalls) {
    bench.machine.program.points = {{"A", {{kTable, 20}}}, {"B", {{kTable, 0}}}};
    bench.machine.program.sequences = {
        {"There and back", {action::MoveTo{"A"}, action::MoveTo{"B"}, action::Repeat{0, 2}}},
        {"Main", {action::Call{"There and back"}, action::Repeat{0, 3}}}};
    bench.start("Main");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    const auto goals = bench.goals();
    ASSERT_EQ(goals.size(), 12U) << "it goes there and back two times three times";
    for (std::size_t i = 0; i < goals.size(); ++i)
        EXPECT_EQ(goals[i].second, i % 2 == 0 ? 20 : 0);
}

TEST_F(Sequences, ForEverGoesOnUntilItIsStopped) {
    bench.machine.program.sequences = {{"Main", {action::Wait{0.1}, action::Repeat{0, 0}}}};
    bench.start("Main");
    bench.turns(1'000);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Running);
    EXPECT_GT(bench.run->report().places[0].rounds.at(1), 50U);
    bench.run->stop();
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
}

TEST_F(Sequences, WaitsForAnInputOrItsTimeout) {
    bench.machine.program.sequences = {
        {"Main",
         {action::WaitForInput{kTable, InputPin::In1, true, 2.0}, action::SetOutput{kTable, 1, true}}}};
    bench.start("Main");
    bench.turns(30);
    EXPECT_EQ(bench.run->report().places[0].row, 0U);
    bench.bus.chain.set(kTable, sim::Input::In1, 1.0, bench.bus.now);
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.outputs() & 0x01U, 0x01U);
    bench.bus.chain.set(kTable, sim::Input::In1, 0.0, bench.bus.now);
    bench.bus.runFor(200ms);
    bench.start("Main");
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::InputTimeout);
    EXPECT_EQ(report.awaited, Action(action::WaitForInput{kTable, InputPin::In1, true, 2.0}));
    EXPECT_EQ(report.places[0].row, 0U);
}

// ---- backlash ----

/// From 0, 0, 0 to A at 1 000, -500, 200, and then X and the table one after the other to B at 0.
TEST_F(Sequences, TakeUpTheBacklashWhereAMoveDoes) {
    bench.modules[0].backlash = {50, false};
    bench.modules[1].backlash = {30, false};
    bench.modules[2].backlash = {40, true};
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"A"}, action::MoveTo{"B", false}}}};
    ASSERT_THAT(whyNotRun("Move", 0, bench.machine, bench.modules), IsEmpty());
    bench.start("Move");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(goalsOf(bench, kX), (std::vector<std::int32_t>{1'000, -50, 0}));
    EXPECT_EQ(goalsOf(bench, kY), (std::vector<std::int32_t>{-530, -500}));
    EXPECT_EQ(goalsOf(bench, kTable), (std::vector<std::int32_t>{240, 200, 0}));
    EXPECT_EQ(bench.goals().back(), (std::pair<int, std::int32_t>{2, 0})) << "after X was back";
    EXPECT_EQ(bench.shafts(), (std::vector<std::int64_t>{0, -500, 0}));
    bench.bus.expectNoViolations();
}

TEST_F(Sequences, WhatTurnsRoundStartsTogetherWithTheOthers) {
    const std::size_t before = bench.bus.sent.size();
    bench.modules[1].backlash = {30, false};
    bench.run = SequenceRun::toPoint(bench.machine, "A");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(loadsAndStarts(before), (std::vector<std::string>{"01 D4", "02 D4", "03 74", "01 05", "02 05",
                                                                "03 05", "02 D4", "02 05"}));
    EXPECT_EQ(goalsOf(bench, kY), (std::vector<std::int32_t>{-530, -500}));
}

/// Its position is read with noise of 10 counts rms.
TEST_F(Sequences, AnAxisThatStaysWhereItIsDoesNotTurnRound) {
    bench.modules[0].backlash = {100, false};
    bench.machine.axes[0].arrival = {60, 0.1};
    bench.modules[0].home.forget();
    bench.machine.program.points = {{"A", {{kX, 1'000, false}}}};
    bench.machine.program.sequences = {{"Main", {action::MoveTo{"A"}, action::Repeat{0, 5}}}};
    bench.bus.chain.set(kX, sim::Input::EncoderNoise, 10.0, bench.bus.now);
    bench.start("Main");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(goalsOf(bench, kX), std::vector<std::int32_t>(5, 1'000));
}

/// Y moves from 0 to -500 from below with 600 counts of play, so it turns round at -1 100. The parameter is
/// the number of the leg, from 0.
class InEitherLeg : public testing::TestWithParam<std::size_t> {
protected:
    void SetUp() override {
        ASSERT_TRUE(bench.ready());
        bench.modules[1].backlash = {600, false};
        bench.machine.program.points = {{"A", {{kY, -500}}}};
        bench.machine.program.sequences = {
            {"Main", {action::MoveTo{"A"}, action::SetOutput{kTable, 2, true}}}};
        bench.start("Main");
        while (bench.goals().size() <= GetParam())
            ASSERT_TRUE(bench.turn());
        bench.turns(2);
        ASSERT_TRUE(bench.modules[1].moving());
    }
    SequenceBench bench;
};

TEST_P(InEitherLeg, AStopEndsItThere) {
    bench.run->stop();
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
    bench.expectRest();
    const std::vector<std::int32_t> legs{-1'100, -500};
    EXPECT_EQ(goalsOf(bench, kY), std::vector(legs.begin(), legs.begin() + 1 + (GetParam() == 1 ? 1 : 0)));
    EXPECT_GT(bench.shafts()[1], -1'100);
    EXPECT_LT(bench.shafts()[1], GetParam() == 0 ? 0 : -500);
    EXPECT_EQ(bench.outputs() & 0x02U, 0U);
}

TEST_P(InEitherLeg, APauseFinishesThemBoth) {
    bench.run->pause();
    bench.turns(1'000);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Paused);
    EXPECT_EQ(bench.run->report().places[0].row, 1U);
    EXPECT_EQ(goalsOf(bench, kY), (std::vector<std::int32_t>{-1'100, -500}));
    EXPECT_EQ(bench.shafts()[1], -500);
    EXPECT_EQ(bench.outputs() & 0x02U, 0U);
    bench.run->resume();
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.outputs() & 0x02U, 0x02U);
}

TEST_P(InEitherLeg, AStopOfTheMotorAloneIsNotFollowedByAnotherLeg) {
    ASSERT_TRUE(bench.order(kY, intent::StopSmoothly{}));
    EXPECT_EQ(bench.goOn().end, SequenceEnd::NotArrived);
    bench.expectRest();
    EXPECT_EQ(goalsOf(bench, kY).size(), GetParam() + 1);
}

INSTANTIATE_TEST_SUITE_P(Legs, InEitherLeg, testing::Values(0U, 1U));

/// A chain of one PIC-I/O: IO3 is an output, all other pins are inputs.
class IoSequences : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bench.connect());
        bench.settle();
        ASSERT_TRUE(bench.perform(iointent::SetDirection{0x0FFB}));
    }
    void start(std::vector<Action> rows) {
        Machine machine;
        machine.program.sequences = {{"Main", std::move(rows)}};
        ASSERT_THAT(whyNotRun("Main", 0, machine, bench.modules), IsEmpty());
        run.emplace(machine, "Main", 0);
    }
    bool turn() {
        bench.bus.runFor(16ms);
        bench.take();
        if (m_operation)
            for (const auto& finished : bench.bus.all<bus::OperationFinished>())
                if (finished.id == *m_operation) {
                    m_operation.reset();
                    run->onFinished(finished.module, finished.outcome);
                    break;
                }
        SequenceRun::Next next = run->next(bench.modules, bench.bus.now);
        if (auto* send = std::get_if<SequenceRun::Send>(&next))
            m_operation = bench.bus.submit(std::move(send->operations.front()));
        return !run->report().over();
    }
    SequenceReport turns(double seconds) {
        for (const TimePoint end = bench.bus.now + fromSeconds(seconds); bench.bus.now < end && turn();) {
        }
        return run->report();
    }
    void set(sim::Input input, unsigned number, double value) {
        bench.bus.chain.set(kX, input, value, bench.bus.now, number);
    }
    [[nodiscard]] sim::IoSnapshot truth() { return *bench.bus.chain.snapshot(kX, bench.bus.now).io; }

    ProcedureBench bench{{{ModuleType::Io, 1}}};
    std::optional<SequenceRun> run;

private:
    std::optional<bus::OperationId> m_operation;
};

TEST_F(IoSequences, AnOutputIsSetWhenTheInputAndThenTheAnalogValueAreThere) {
    start({action::WaitForInput{kX, InputPin::Io12, true, 5.0}, action::WaitForAnalog{kX, 2, true, 199, 5.0},
           action::SetOutput{kX, 3, true}});
    EXPECT_EQ(turns(1).places[0].row, 0U);
    set(sim::Input::Pin, 12, 1);
    EXPECT_EQ(turns(1).places[0].row, 1U);
    set(sim::Input::Analog, 2, 199);
    EXPECT_EQ(turns(1).places[0].row, 1U) << "199 is not above 199";
    EXPECT_EQ(truth().outputs & 0x0004U, 0U);
    set(sim::Input::Analog, 2, 200);
    EXPECT_EQ(turns(2).stage, SequenceStage::Done);
    EXPECT_EQ(truth().outputs & 0x0FFFU, 0x0004U);
    bench.bus.expectNoViolations();
}

TEST_F(IoSequences, AWaitForAnAnalogValueEndsInTime) {
    start({action::WaitForAnalog{kX, 1, true, 10, 2.0}, action::SetOutput{kX, 3, true}});
    EXPECT_EQ(turns(1.8).stage, SequenceStage::Running);
    const SequenceReport report = turns(0.5);
    EXPECT_EQ(report.end, SequenceEnd::AnalogTimeout);
    EXPECT_EQ(report.awaited, Action(action::WaitForAnalog{kX, 1, true, 10, 2.0}));
    EXPECT_EQ(report.module, kX);
    EXPECT_EQ(truth().outputs, 0U);
}

TEST_F(IoSequences, SaysThatItsOutputHasBecomeAnInput) {
    start({action::WaitForInput{kX, InputPin::Io1, true, 5.0}, action::SetOutput{kX, 3, true}});
    EXPECT_EQ(turns(0.5).stage, SequenceStage::Running);
    ASSERT_TRUE(bench.perform(iointent::SetDirection{0x0FFF}));
    set(sim::Input::Pin, 1, 1);
    const SequenceReport report = turns(1);
    EXPECT_EQ(report.end, SequenceEnd::NotAnOutput);
    EXPECT_EQ(report.module, kX);
    EXPECT_EQ(truth().outputs, 0U);
}

TEST_F(IoSequences, AStopOfAllEndsTheWaitAndNothingIsSetBehindIt) {
    start({action::WaitForInput{kX, InputPin::Io1, true, 5.0}, action::SetOutput{kX, 3, true}});
    EXPECT_EQ(turns(0.5).stage, SequenceStage::Running);
    run->onStopOfAll();
    set(sim::Input::Pin, 1, 1);
    EXPECT_EQ(turns(1).end, SequenceEnd::StopOfAll);
    EXPECT_EQ(truth().outputs, 0U);
}

TEST_F(Sequences, HomesAnAxisByItsRecipe) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.reverse = false;
    recipe.velocity = 490.0;
    recipe.acceleration = 2'000.0;
    recipe.travelLimit = 4'000.0;
    recipe.timeLimit = 20.0;
    bench.machine.axes[2].homing = recipe;
    bench.bus.chain.set(kTable, sim::Input::HomeSwitchAt, 300.0, bench.bus.now);
    bench.modules[2].home.forget();
    bench.machine.program.sequences = {
        {"Main", {action::Home{kTable}, action::MoveTo{"B"}, action::Wait{0.2}}}};
    ASSERT_THAT(whyNotRun("Main", 0, bench.machine, bench.modules), IsEmpty());
    bench.start("Main");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_NEAR(static_cast<double>(bench.shafts()[2]), 300, 1) << "B is at home";

    bench.bus.chain.set(kTable, sim::Input::HomeSwitchAt, std::nullopt, bench.bus.now);
    bench.modules[2].home.forget();
    bench.start("Main");
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::NotHomed);
    EXPECT_EQ(report.module, kTable);
    bench.expectRest();
}

/// The gains from before are sent again while the search has already been asked for.
TEST_F(Sequences, TheEndOfATrialIsNotThatOfItsHomeSearch) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.reverse = false;
    recipe.velocity = 490.0;
    recipe.acceleration = 2'000.0;
    recipe.travelLimit = 4'000.0;
    recipe.timeLimit = 20.0;
    bench.machine.axes[2].homing = recipe;
    bench.bus.chain.set(kTable, sim::Input::HomeSwitchAt, 300.0, bench.bus.now);
    bench.machine.program.sequences = {{"Main", {action::Home{kTable}, action::Wait{0.2}}}};
    bench.start("Main");
    while (!bench.procedure && bench.turn()) {
    }
    bench.run->onProcedure(
        {.module = kTable, .kind = ProcedureKind::TryGains, .stage = ProcedureStage::Cancelled});
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
}

/// The table is taught at 200 steps by the counter. The search finds its home, so the second pass may not go
/// there. X, which comes first in the point, does not move again either.
TEST_F(Sequences, APointTaughtWithoutHomeIsNotUsedOnceHomeIsFound) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.reverse = false;
    recipe.velocity = 490.0;
    recipe.acceleration = 2'000.0;
    recipe.travelLimit = 4'000.0;
    recipe.timeLimit = 20.0;
    bench.machine.axes[2].homing = recipe;
    bench.bus.chain.set(kTable, sim::Input::HomeSwitchAt, 300.0, bench.bus.now);
    bench.modules[2].home.forget();
    bench.machine.program.points = {{"A", {{kX, 1'000}, {kTable, 200, false}}}, {"B", {{kX, 0}}}};
    bench.machine.program.sequences = {
        {"Main",
         {action::MoveTo{"A", false}, action::MoveTo{"B"}, action::Home{kTable}, action::Repeat{0, 2}}}};
    ASSERT_THAT(whyNotRun("Main", 0, bench.machine, bench.modules), IsEmpty());
    bench.start("Main");
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::TaughtElsewhere);
    EXPECT_EQ(report.module, kTable);
    EXPECT_EQ(report.taught, "A");
    EXPECT_EQ(report.places[0].row, 0U);
    EXPECT_EQ(goalsOf(bench, kX), (std::vector<std::int32_t>{1'000, 0}));
    bench.expectRest();
    EXPECT_NEAR(static_cast<double>(bench.shafts()[2]), 300, 1) << "it stays at home";
}

// ---- limit stop for each motion ----

/// The panel arms the limit stop of X, but only five turns after it is due.
SequenceReport goOnArmingLate(SequenceBench& bench) {
    unsigned turns = 0;
    for (const TimePoint end = bench.bus.now + 60s; bench.turn() && bench.bus.now < end;)
        if (const auto arm = limitStopDue(bench.modules[0]); arm && !bench.procedure && ++turns % 5 == 0) {
            EXPECT_TRUE(bench.order(kX, *arm));
        }
    return bench.run->report();
}

TEST_F(Sequences, AMoveWaitsForTheLimitStopThatAHomeSearchHasReplaced) {
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    bench.machine.axes[0].homing = recipe;
    bench.modules[0].home.forget();
    bench.putSwitch(sim::Input::Limit1, -600, true);
    bench.modules[0].limitStop = {.eachMotion = true, .stop = {.onLimit2 = true}};
    ASSERT_TRUE(bench.order(kX, *limitStopDue(bench.modules[0])));
    bench.machine.program.points = {{"A", {{kX, 300}}}};
    bench.machine.program.sequences = {{"Main", {action::Home{kX}, action::MoveTo{"A"}}}};
    ASSERT_THAT(whyNotRun("Main", 0, bench.machine, bench.modules), IsEmpty());
    bench.start("Main");
    EXPECT_EQ(goOnArmingLate(bench).stage, SequenceStage::Done);
    EXPECT_NEAR(goalsOf(bench, kX).back(), 300, 1) << "home is 0 now";
    EXPECT_TRUE(bench.modules[0].homing.onLimit2());
    bench.bus.expectNoViolations();
}

/// X leaves limit switch 1 in reverse, and turns round at -550, where that limit is armed as well.
TEST_F(Sequences, AMotorThatHasLeftALimitWaitsForItsLimitStopBeforeItTurnsRound) {
    bench.putSwitch(sim::Input::Limit1, -10, false);
    bench.modules[0].backlash = {50, false};
    bench.modules[0].limitStop.eachMotion = true;
    bench.settle();
    ASSERT_TRUE(bench.order(kX, *limitStopDue(bench.modules[0])));
    ASSERT_FALSE(bench.modules[0].homing.onLimit1()) << "the motor stands on that one";
    bench.machine.program.points = {{"A", {{kX, -500}}}};
    bench.run = SequenceRun::toPoint(bench.machine, "A");
    EXPECT_EQ(goOnArmingLate(bench).stage, SequenceStage::Done);
    EXPECT_EQ(goalsOf(bench, kX), (std::vector<std::int32_t>{-550, -500}));
    EXPECT_TRUE(bench.modules[0].homing.onLimit1());
    bench.bus.expectNoViolations();
}

TEST_F(Sequences, AMoveIsRefusedIfItsLimitStopIsNeverArmed) {
    bench.modules[0].limitStop.eachMotion = true;
    bench.run = SequenceRun::toPoint(bench.machine, "A");
    const SequenceReport report = bench.goOn(5.0);
    EXPECT_EQ(report.end, SequenceEnd::Refused);
    EXPECT_EQ(report.module, kX);
    EXPECT_EQ(report.refusal, Refusal::LimitStopDue);
    EXPECT_THAT(bench.goals(), IsEmpty());
}

TEST_F(Sequences, AStopInAHomeSearchStopsIt) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.reverse = false;
    recipe.velocity = 100.0;
    recipe.acceleration = 2'000.0;
    recipe.travelLimit = 4'000.0;
    recipe.timeLimit = 20.0;
    bench.machine.axes[2].homing = recipe;
    bench.machine.program.sequences = {{"Main", {action::Home{kTable}}}};
    bench.start("Main");
    bench.turns(60);
    ASSERT_TRUE(bench.modules[2].moving());
    bench.run->stop();
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
    bench.expectRest();
}

TEST_F(Sequences, TheOtherMotorsAreStoppedWhileAHomeSearchIsCancelled) {
    HomingRecipe recipe;
    recipe.onHomeSwitch = true;
    recipe.reverse = false;
    recipe.velocity = 100.0;
    recipe.acceleration = 2'000.0;
    recipe.travelLimit = 4'000.0;
    recipe.timeLimit = 20.0;
    bench.machine.axes[2].homing = recipe;
    bench.machine.program.points = {{"Far", {{kX, 10'000}}}};
    bench.machine.program.sequences = {{"Main", {action::MoveTo{"Far", true, false}, action::Home{kTable}}}};
    bench.start("Main");
    bench.turns(60);
    ASSERT_TRUE(bench.modules[0].moving() && bench.modules[2].moving());
    bench.run->stop();
    const SequenceRun::Next cancel = bench.run->next(bench.modules, bench.bus.now);
    ASSERT_TRUE(std::holds_alternative<SequenceRun::Ask>(cancel));
    EXPECT_EQ(sent(), 1U) << "the stop of X";
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Stopping) << "the search has not ended yet";
}

/// The load of Y is answered, but the answers are lost. The first retry comes after a quarantine of at least
/// 100 ms (docs/link.md 2.1); five turns are 80 ms.
TEST_F(Sequences, AStopDoesNotWaitForAModuleThatDoesNotAnswer) {
    bench.machine.program.points = {{"X", {{kX, 10'000}}}, {"Y", {{kY, -500}}}};
    bench.machine.program.sequences = {
        {"Main", {action::MoveTo{"X", true, false}, action::Wait{0.3}, action::MoveTo{"Y"}}}};
    bench.start("Main");
    const auto loadsOfY = [this] { return bench.bus.sends("AA 02 D4"); };
    bench.bus.losesReply = [](ByteSpan command) { return toHex(command).rfind("AA 02 D4", 0) == 0; };
    while (loadsOfY() == 0)
        ASSERT_TRUE(bench.turn());
    ASSERT_TRUE(bench.modules[0].moving());
    const std::size_t before = bench.bus.sent.size();
    bench.run->stop();
    bench.turns(5);
    EXPECT_EQ(loadsOfY(), 1U);
    EXPECT_GT(bench.bus.sends("AA 01 17 09 21", before), 0U) << "smoothly, with the amplifier on";
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
    bench.expectRest();
    EXPECT_LT(bench.shafts()[0], 5'000);
    EXPECT_NEAR(static_cast<double>(bench.shafts()[1]), 0, 2) << "it was loaded at most";
}

/// An order that is in flight may start its motor after the first stop.
TEST_F(Sequences, WhatIsInFlightIsStoppedAgainAtItsEnd) {
    bench.start("Main");
    ASSERT_EQ(sent(), 1U) << "the move of all three";
    bench.run->stop();
    EXPECT_EQ(sent(), 3U);
    EXPECT_EQ(sent(), 0U) << "now the results are awaited";
    bench.run->onFinished(kX, bus::Outcome::Done);
    for (int stop = 0; stop < 3; ++stop) {
        EXPECT_EQ(sent(), 0U);
        EXPECT_EQ(bench.run->report().stage, SequenceStage::Stopping);
        bench.run->onFinished(kX, bus::Outcome::Done);
    }
    EXPECT_EQ(sent(), 3U);
    for (int stop = 0; stop < 3; ++stop)
        bench.run->onFinished(kX, bus::Outcome::Done);
    EXPECT_EQ(sent(), 0U);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Over);
}

/// One reply says that X is off, so its stop waits for the next one; meanwhile the others are sent theirs
/// once, and again only when what is in flight to them has ended.
TEST_F(Sequences, AStopThatWaitsForAReplyRepeatsNoOther) {
    bench.start("Main");
    ASSERT_EQ(sent(), 1U) << "the move of all three";
    bench.sayOff(0);
    ASSERT_TRUE(bench.modules[0].maybeOff());
    bench.run->stop();
    EXPECT_EQ(sent(), 2U) << "the stops of the other two";
    EXPECT_EQ(sent(), 0U) << "the results are awaited";
    for (int order = 0; order < 3; ++order) {
        EXPECT_EQ(sent(), 0U);
        bench.run->onFinished(kY, bus::Outcome::Done);
    }
    EXPECT_EQ(sent(), 2U);
    for (int stop = 0; stop < 2; ++stop)
        bench.run->onFinished(kY, bus::Outcome::Done);
    EXPECT_EQ(sent(), 0U);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Stopping);
    bench.bus.runFor(100ms);
    bench.take();
    ASSERT_FALSE(bench.modules[0].maybeOff());
    EXPECT_EQ(sent(), 1U);
    bench.run->onFinished(kX, bus::Outcome::Done);
    EXPECT_EQ(sent(), 0U);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Over);
}

TEST_F(Sequences, APauseFinishesTheRowAndChangesNothingElse) {
    bench.start("Main");
    bench.turns(10);
    bench.run->pause();
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Pausing);
    bench.turns(1'000);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Paused);
    EXPECT_EQ(bench.run->report().places[0].row, 1U);
    EXPECT_EQ(bench.shafts(), (std::vector<std::int64_t>{1'000, -500, 200})) << "the move was finished";
    bench.run->resume();
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.goals().size(), 8U);
    bench.bus.expectNoViolations();
}

TEST_F(Sequences, StepByStepDoesEachRowOnce) {
    bench.start("Main", 0, true);
    for (std::size_t row = 1; row < 7; ++row) {
        bench.turns(1'000);
        ASSERT_EQ(bench.run->report().stage, SequenceStage::Paused);
        ASSERT_EQ(bench.run->report().places[0].row, row);
        bench.run->step();
    }
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.goals().size(), 8U);
}

TEST_F(Sequences, AMoveToAPoint) {
    bench.run = SequenceRun::toPoint(bench.machine, "A");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.shafts(), (std::vector<std::int64_t>{1'000, -500, 200}));
}

TEST_F(Sequences, AnythingElseThatIsAskedOfOneOfItsModulesEndsIt) {
    bench.start("Main");
    bench.turns(15);
    bench.run->onTakenOver(ModuleIndex(9));
    EXPECT_FALSE(bench.run->report().end) << "that module is none of its own";
    ASSERT_TRUE(bench.order(kX, intent::StopSmoothly{}));
    bench.run->onTakenOver(kX);
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::TakenOver);
    EXPECT_EQ(report.module, kX);
    bench.expectRest();
}

TEST_F(Sequences, WhatIsToldSomethingElseDoesNotGoOnUnwatched) {
    bench.start("Main");
    bench.turns(15);
    ASSERT_TRUE(bench.modules[0].moving());
    bench.run->onTakenOver(kX, false);
    EXPECT_EQ(bench.goOn().end, SequenceEnd::TakenOver);
    bench.expectRest();
    EXPECT_LT(std::abs(bench.shafts()[0]), 990) << "it was stopped on its way to 1 000";
}

TEST_F(Sequences, AStartOfAGroupThatIsWithheldTakesNothingOver) {
    bench.start("Main");
    bench.turns(15);
    ASSERT_TRUE(bench.modules[0].moving());
    bus::GroupFinished finished{bus::OperationId(999),
                                bus::Outcome::Forbidden,
                                bus::GroupCommand{},
                                {{kX, bus::MemberOutcome::Withheld}},
                                false};
    SequenceNews{*bench.run}(finished);
    EXPECT_FALSE(bench.run->report().end) << "nothing was sent";
    finished.members.front().outcome = bus::MemberOutcome::Done;
    SequenceNews{*bench.run}(finished);
    EXPECT_EQ(bench.run->report().end, SequenceEnd::TakenOver);
}

TEST_F(Sequences, WhatIsPutIntoAnotherGroupDoesNotGoOnUnwatched) {
    bench.start("Main");
    bench.turns(15);
    ASSERT_TRUE(bench.modules[0].moving());
    const bus::GroupFinished finished{bus::OperationId(999),
                                      bus::Outcome::Done,
                                      bus::GroupChange{kX, {}},
                                      {{kX, bus::MemberOutcome::Done}},
                                      false};
    SequenceNews{*bench.run}(finished);
    EXPECT_EQ(bench.goOn().end, SequenceEnd::TakenOver);
    bench.expectRest();
    EXPECT_LT(std::abs(bench.shafts()[0]), 990) << "it was stopped on its way to 1 000";
}

TEST_F(Sequences, StopsThatFindTheQueueFullAreSentAgain) {
    bench.start("Main");
    bench.turns(15);
    ASSERT_TRUE(bench.modules[0].moving());
    bench.run->stop();
    const std::size_t stops = sent();
    ASSERT_GT(stops, 0U);
    for (std::size_t i = 0; i < stops; ++i)
        bench.run->onFinished(kX, bus::Outcome::QueueFull);
    EXPECT_EQ(sent(), stops);
    for (std::size_t i = 0; i < stops; ++i)
        bench.run->onFinished(kX, bus::Outcome::Done);
    EXPECT_EQ(sent(), 0U);
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Over);
    EXPECT_EQ(bench.run->report().end, SequenceEnd::ByUser);
}

TEST_F(Sequences, AStopThatItWasNotToldOfEndsIt) {
    bench.start("Main");
    bench.turns(15);
    ASSERT_TRUE(bench.order(kY, intent::StopAbruptly{}));
    EXPECT_EQ(bench.goOn().end, SequenceEnd::NotArrived);
    bench.expectRest();
}

/// An encoder with noise of 10 counts rms never stands still, as far as its reports show, and is rarely
/// within a count of anything, but always within 60.
TEST_F(Sequences, AnAxisThatNeverStandsStillArrivesWithinItsTolerance) {
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"A"}}}};
    bench.machine.axes[0].arrival = {60, 0.1};
    bench.bus.chain.set(kX, sim::Input::EncoderNoise, 10.0, bench.bus.now);
    bench.start("Move");
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
}

TEST_F(Sequences, AnAxisThatDoesNotStayWithinItsToleranceEndsIt) {
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"A"}, action::MoveTo{"B"}}}};
    bench.machine.axes[0].arrival = {1, 0.5};
    bench.bus.chain.set(kX, sim::Input::EncoderNoise, 10.0, bench.bus.now);
    bench.start("Move");
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::NotSettled);
    EXPECT_EQ(report.module, kX);
    bench.expectRest();
    EXPECT_NEAR(static_cast<double>(bench.shafts()[0]), 1'000, 60) << "it did not go on to B";
}

// ---- one reply that says that a motor is off ----

/// The parameter is the module: a servo, and the PIC-STEP.
class OneReplyThatSaysItIsOff : public Sequences, public testing::WithParamInterface<std::uint8_t> {
protected:
    [[nodiscard]] ModuleState& module() { return bench.modules.at(GetParam()); }
    /// Stop Motor has one data byte (DS-V 5.2, DS-S 5.1).
    [[nodiscard]] std::size_t stops() const {
        return bench.bus.sends("AA 0" + std::to_string(GetParam() + 1) + " 17", m_before);
    }
    [[nodiscard]] bool isOn() {
        return module().isStepper() ? bench.bus.chain.snapshot(kTable, bench.bus.now).stepper->ampEnabled
                                    : bench.bus.servo(GetParam()).servoOn;
    }
    /// Goes on until the module moves, and has that reply then.
    void startAndSayOff(const std::string& sequence) {
        bench.start(sequence);
        bench.turns(10);
        ASSERT_TRUE(module().moving());
        m_before = bench.bus.sent.size();
        bench.sayOff(GetParam());
        ASSERT_TRUE(module().maybeOff());
    }

private:
    std::size_t m_before = 0;
};

TEST_P(OneReplyThatSaysItIsOff, EndsNothing) {
    ASSERT_NO_FATAL_FAILURE(startAndSayOff("Main"));
    EXPECT_EQ(sent(), 0U);
    EXPECT_FALSE(bench.run->report().end);
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(stops(), 0U);
    EXPECT_EQ(bench.shafts(), (std::vector<std::int64_t>{1'000, -500, 200}));
    bench.bus.expectNoViolations();
}

TEST_P(OneReplyThatSaysItIsOff, DelaysItsStopAndNoOther) {
    ASSERT_NO_FATAL_FAILURE(startAndSayOff("Main"));
    bench.run->stop();
    EXPECT_EQ(sent(), 2U) << "the stops of the other two";
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Stopping);
}

TEST_P(OneReplyThatSaysItIsOff, KeepsNoStopFromIt) {
    bench.machine.program.points = {{"Far", {{ModuleIndex(GetParam()), 10'000}}}};
    bench.machine.program.sequences = {{"Move", {action::MoveTo{"Far"}}}};
    ASSERT_NO_FATAL_FAILURE(startAndSayOff("Move"));
    bench.run->stop();
    EXPECT_EQ(sent(), 0U) << "it might switch the motor on";
    EXPECT_EQ(bench.run->report().stage, SequenceStage::Stopping);
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
    EXPECT_EQ(stops(), 1U);
    bench.expectRest();
    EXPECT_LT(bench.shafts().at(GetParam()), 9'000);
    EXPECT_TRUE(isOn());
}

INSTANTIATE_TEST_SUITE_P(Motors, OneReplyThatSaysItIsOff, testing::Values(std::uint8_t{0}, std::uint8_t{2}));

// ---- at every moment ----

/// Moments at which a run is disturbed, spread evenly over its length.
constexpr int kMoments = 12;

class AtAnyMoment : public testing::TestWithParam<int> {
protected:
    /// Runs the sequence up to the moment in question, and another bench to its end. In the second half of
    /// the tests, the axes have backlash to take up.
    void SetUp() override {
        SequenceBench whole;
        for (SequenceBench* each : {&bench, &whole}) {
            ASSERT_TRUE(each->ready());
            for (ModuleState& module : each->modules)
                module.backlash.distance = GetParam() < kMoments ? 0.0 : 60.0;
            each->start("Main");
        }
        int length = 0;
        for (; whole.turn(); ++length) {
        }
        last = whole.shafts();
        bench.turns(1 + GetParam() % kMoments * length / kMoments);
        ASSERT_FALSE(bench.run->report().over());
    }
    SequenceBench bench;
    std::vector<std::int64_t> last;
};

TEST_P(AtAnyMoment, AStopEndsItForGood) {
    bench.run->stop();
    EXPECT_EQ(bench.goOn().end, SequenceEnd::ByUser);
    bench.run->resume();
    bench.run->step();
    EXPECT_FALSE(bench.turn());
    bench.expectRest();
}

TEST_P(AtAnyMoment, AStopOfAllEndsIt) {
    bench.run->onStopOfAll();
    ASSERT_TRUE(bench.bus.stopAll());
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.stage, SequenceStage::Over);
    EXPECT_EQ(report.end, SequenceEnd::StopOfAll);
    bench.expectRest();
}

TEST_P(AtAnyMoment, ALostLinkIsADoubtThatStopsTheMotors) {
    bench.bus.losesReply = [](ByteSpan) { return true; };
    const SequenceReport report = bench.goOn();
    ASSERT_TRUE(report.end);
    const SequenceEnd end = *report.end;
    EXPECT_TRUE(end == SequenceEnd::LinkInDoubt || end == SequenceEnd::Unresponsive ||
                end == SequenceEnd::NotExecuted)
        << static_cast<int>(end);
    bench.bus.runFor(5s);
    const auto was = bench.shafts();
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.shafts(), was);
}

TEST_P(AtAnyMoment, ALimitThatClosesOnTheWayEndsIt) {
    bool moved = false;
    // Runs on until a row moves X.
    while (!(moved = bench.modules[0].moving()) && bench.turn()) {
    }
    if (!moved)
        return;  // X does not move any more
    bench.turns(3);
    if (!bench.modules[0].moving())
        return;  // X has just arrived
    bench.set(sim::Input::Limit1, 1.0);
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.end, SequenceEnd::LimitClosed);
    EXPECT_EQ(report.module, kX);
    bench.expectRest();
}

TEST_P(AtAnyMoment, AMotorThatGoesOffEndsIt) {
    bench.bus.chain.set(kY, sim::Input::Power, 0.0, bench.bus.now);
    const SequenceReport report = bench.goOn();
    EXPECT_EQ(report.stage, SequenceStage::Over);
    EXPECT_TRUE(report.end == SequenceEnd::WentOff || report.end == SequenceEnd::Refused)
        << static_cast<int>(*report.end);
    EXPECT_EQ(report.module, kY);
    bench.expectRest();
}

TEST_P(AtAnyMoment, ItIsResumedOnlyFromAStateThatAFreshRunWouldBeIn) {
    bench.run->stop();
    const SequenceReport report = bench.goOn();
    bench.bus.runFor(2s);
    bench.take();
    const std::size_t row = report.places[0].row;
    const EntryState entry = entryState(bench.machine, "Main", row);
    // Axes are moved by hand to where whyNotRun() requires them.
    for (const auto& problem : whyNotRun("Main", row, bench.machine, bench.modules)) {
        ASSERT_TRUE(problem.kind == SequenceProblem::Kind::NotThere ||
                    problem.kind == SequenceProblem::Kind::NotSet)
            << static_cast<int>(problem.kind);
        if (problem.kind == SequenceProblem::Kind::NotThere) {
            const auto& place = entry.places.at(*problem.module);
            const auto wanted = moveIntent(place.axis, 100, bench.modules[problem.module->value()],
                                           bench.machine.axis(*problem.module));
            ASSERT_TRUE(bench.order(*problem.module, *wanted));
            bench.bus.runFor(3s);
            bench.take();
        }
    }
    ASSERT_THAT(whyNotRun("Main", row, bench.machine, bench.modules), IsEmpty());
    bench.start("Main", row);
    EXPECT_EQ(bench.goOn().stage, SequenceStage::Done);
    EXPECT_EQ(bench.shafts(), last);
    EXPECT_EQ(bench.outputs() & 0x02U, 0U);
    bench.bus.expectNoViolations();
}

INSTANTIATE_TEST_SUITE_P(Moments, AtAnyMoment, testing::Range(0, 2 * kMoments));

}  // namespace
}  // namespace nmc::test
