// SPDX-License-Identifier: GPL-3.0-or-later
// A home search on a PIC-SERVO, DS-V 5.2 Set Homing Mode: where the switch really is, is read from the
// simulator.
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Stop = HomingRecipe::Stop;
using Input = sim::Input;

/// How far off the switch may be: it is operated between two bytes on the line, 0.17 ticks at 0.5 counts
/// each.
constexpr double kSwitchIsAt = 2.0;

/// Expects position 0 of the chip to be where the shaft really is at `shaft`.
void expectZeroAt(ServoBench& bench, double shaft) {
    const auto truth = bench.truth();
    EXPECT_NEAR(truth.shaftCounts - truth.position, shaft, kSwitchIsAt);
    EXPECT_NEAR(truth.position, 0, 1);
    EXPECT_EQ(truth.commandVelocity, 0);
    EXPECT_TRUE(truth.servoOn);
}

class EachVersion : public testing::TestWithParam<int> {
protected:
    EachVersion() : bench(static_cast<std::uint8_t>(GetParam())) {}
    ServoBench bench;
};

TEST_P(EachVersion, FindsALimitSwitchGoesThereAndMakesItZero) {
    bench.putSwitch(Input::Limit1, -1'000, true);
    ASSERT_TRUE(bench.enable());
    bench.watchesSpeed = true;
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_FALSE(report.failure);
    EXPECT_GT(bench.fastest, 0);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, -1'000, kSwitchIsAt);
    expectZeroAt(bench, -1'000);
    EXPECT_LE(bench.fastest, 0.5);
    EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
    EXPECT_EQ(bench.module().homing.state(), HomeWatch::State::Idle);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, StopsByItsRecipe) {
    for (const Stop stop : {Stop::Abruptly, Stop::Smoothly, Stop::Off}) {
        SCOPED_TRACE(static_cast<int>(stop));
        ServoBench own(static_cast<std::uint8_t>(GetParam()));
        own.putSwitch(Input::Limit2, 700, false);
        ASSERT_TRUE(own.enable());
        HomingRecipe recipe = slowRecipe();
        recipe.onLimit2 = true;
        recipe.reverse = false;
        recipe.stop = stop;
        recipe.goToHome = recipe.makeZero = false;
        const ProcedureReport report = own.run(intent::Home{recipe});
        EXPECT_EQ(report.stage, ProcedureStage::Done);
        ASSERT_TRUE(report.home);
        EXPECT_NEAR(*report.home, 700, kSwitchIsAt);
        const auto truth = own.truth();
        EXPECT_EQ(truth.servoOn, stop != Stop::Off);
        EXPECT_NEAR(truth.velocity, 0, 0.01);
        EXPECT_LT(truth.position, 850) << "0.5 counts/tick for 100 ms are 98 counts";
        EXPECT_FALSE(own.module().switchedItselfOff) << "nothing went wrong";
        own.bus.expectNoViolations();
    }
}

TEST_P(EachVersion, BacksOffFromASwitchThatIsActiveAlready) {
    bench.putSwitch(Input::Limit1, 600, true);
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::BackingOff) == 1);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, 600, kSwitchIsAt) << "where it closes, not where it opens";
    expectZeroAt(bench, 600);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, FindsTheLimitThenTheIndexInTheOtherDirection) {
    bench.putSwitch(Input::Limit1, -1'300, true);
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(500));
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = recipe.thenIndex = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::SearchingIndex) == 1);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, 0, 1)
        << "there is one index in 2 000 counts, and this is the next one forward of -1 300";
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, TheIndexItStandsOnIsFoundFromTheOtherSide) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.truth().index);
    HomingRecipe recipe = slowRecipe();
    recipe.onIndex = true;
    recipe.velocity = 0.1;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::BackingOff) == 1);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, 0, 1);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, APositionErrorAtAHardStopIsHomeAndTheServoStaysOff) {
    ASSERT_TRUE(bench.enable(200));
    bench.set(Input::TravelMin, -800);
    HomingRecipe recipe = slowRecipe();
    recipe.onPositionError = true;
    recipe.goToHome = recipe.makeZero = false;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, -800, 2);
    EXPECT_FALSE(bench.truth().servoOn);
    EXPECT_FALSE(bench.module().switchedItselfOff);
    EXPECT_EQ(bench.module().activity(), Activity::ServoOff);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, BehindAPositionErrorItIsSwitchedOnAgainForWhatWasAskedFor) {
    ASSERT_TRUE(bench.enable(200));
    bench.set(Input::TravelMin, -800);
    HomingRecipe recipe = slowRecipe();
    recipe.onPositionError = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    expectZeroAt(bench, -800);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, TheIndexBehindAHardStop) {
    ASSERT_TRUE(bench.enable(200));
    ASSERT_TRUE(bench.moveTo(300));
    bench.set(Input::TravelMin, -800);
    HomingRecipe recipe = slowRecipe();
    recipe.onPositionError = recipe.thenIndex = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, 0, 1);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, CurrentLimitingAtAHardStopIsHome) {
    ASSERT_TRUE(bench.enable(4'000, 101));
    bench.set(Input::TravelMin, -800);
    HomingRecipe recipe = slowRecipe();
    recipe.onCurrentLimit = true;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, -800, 2);
    bench.bus.expectNoViolations();
}

TEST_P(EachVersion, TheCurrentThatStartingTakesIsNotHome) {
    ASSERT_TRUE(bench.enable(4'000, 51));
    bench.set(Input::TravelMin, -800);
    HomingRecipe recipe = slowRecipe();
    recipe.onCurrentLimit = true;
    // It accelerates within four ticks. An error of 2 counts in the first one gives a PWM value of (200 x 2 +
    // 2 000 x 2) / 256 = 17, which is 1.6 V or 1.5 A; 51 is 1 A.
    recipe.velocity = 8;
    recipe.acceleration = 2;
    const ProcedureReport report = bench.run(intent::Home{recipe});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.home);
    EXPECT_NEAR(*report.home, -800, 2);
    bench.bus.expectNoViolations();
}

INSTANTIATE_TEST_SUITE_P(Servo, EachVersion, testing::Values(1, 2, 3, 4, kPathVersion, kScVersion));

// ---- what can go wrong ----

class Failing : public testing::Test {
protected:
    void expectFailure(const ProcedureReport& report, ProcedureFailure failure) {
        EXPECT_EQ(report.stage, ProcedureStage::Failed);
        ASSERT_TRUE(report.failure);
        EXPECT_EQ(*report.failure, failure) << static_cast<int>(*report.failure);
        expectQuiet();
    }
    void expectQuiet() {
        EXPECT_EQ(bench.truth().commandVelocity, 0);
        EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
        EXPECT_EQ(bench.bus.sends("AA 01 00"), 0U) << "zero is not set";
        bench.bus.expectNoViolations();
    }
    HomingRecipe onLimit1() {
        HomingRecipe recipe = slowRecipe();
        recipe.onLimit1 = true;
        return recipe;
    }
    ServoBench bench;
};

TEST_F(Failing, M14_WithoutASwitchTheTravelLimitEndsIt) {
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = onLimit1();
    recipe.travelLimit = 1'500;
    expectFailure(bench.run(intent::Home{recipe}), ProcedureFailure::TravelLimit);
    EXPECT_NEAR(bench.truth().position, -1'500, 100);
    EXPECT_TRUE(bench.truth().servoOn) << "it still holds";
}

TEST_F(Failing, M14_WithoutASwitchTheTimeLimitEndsIt) {
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = onLimit1();
    recipe.timeLimit = 2;
    expectFailure(bench.run(intent::Home{recipe}), ProcedureFailure::TimeLimit);
    // 0.5 counts/tick x 1953 ticks/s x 2 s, plus about 50 ms to notice and to stop, minus the ramp.
    EXPECT_NEAR(bench.truth().position, -1'953, 100);
}

TEST_F(Failing, M16_ASwitchThatStaysActiveIsNotSearched) {
    bench.set(Input::Limit1, 1);
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = onLimit1();
    recipe.travelLimit = 500;
    expectFailure(bench.run(intent::Home{recipe}), ProcedureFailure::SwitchActive);
    EXPECT_NEAR(bench.truth().position, 500, 100) << "it backed off as far as it may";
    EXPECT_EQ(bench.bus.sends("AA 01 19 11"), 0U);
}

TEST_F(Failing, ATripOnTheWayIsNotHome) {
    ASSERT_TRUE(bench.enable(200));
    bench.set(Input::TravelMin, -500);
    expectFailure(bench.run(intent::Home{onLimit1()}), ProcedureFailure::WentOff);
    EXPECT_FALSE(bench.truth().servoOn) << "it is not switched on again";
    EXPECT_TRUE(bench.module().switchedItselfOff);
}

TEST_F(Failing, ATripInASearchThatEndsWithTheMotorOffIsNotHomeEither) {
    ASSERT_TRUE(bench.enable(200));
    bench.set(Input::TravelMin, -500);
    HomingRecipe recipe = onLimit1();
    recipe.stop = Stop::Off;
    expectFailure(bench.run(intent::Home{recipe}), ProcedureFailure::WentOff);
    EXPECT_FALSE(bench.truth().servoOn);
    EXPECT_TRUE(bench.module().switchedItselfOff);
}

TEST_F(Failing, AServoThatCannotReachItsHomeExactlyMakesNoZero) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -1'000, true);
    // Without Ki, friction keeps it some counts off.
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{20, 500, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    bench.set(Input::Friction, 0.02);
    HomingRecipe recipe = onLimit1();
    recipe.stop = Stop::Smoothly;
    expectFailure(bench.run(intent::Home{recipe}), ProcedureFailure::NotAtHome);
    EXPECT_NEAR(bench.procedure->report().home.value_or(0), -1'000, kSwitchIsAt)
        << "home was found all the same";
}

TEST_F(Failing, TwoReadingsThatDifferAreNoHome) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -400, true);
    unsigned turns = 0;
    bench.onTurn = [&](Procedure& run) {
        // The first reading reports another home.
        if (run.report().stage == ProcedureStage::Reading && ++turns == 1)
            bench.module().latest->home = -399;
    };
    expectFailure(bench.run(intent::Home{onLimit1()}), ProcedureFailure::ReadingsDiffer);
    EXPECT_FALSE(bench.procedure->report().home);
}

TEST_F(Failing, M15_ALinkInDoubtIsNeverHomed) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -1'000, true);
    bench.begin(intent::Home{onLimit1()});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.procedure->onLinkSuspect();
    expectFailure(bench.goOn(), ProcedureFailure::LinkSuspect);
    EXPECT_GT(bench.truth().position, -900) << "it is stopped at once";
}

TEST_F(Failing, AModuleThatFallsSilentIsNeverHomed) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -1'000, true);
    bench.begin(intent::Home{onLimit1()});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.bus.losesReply = [](ByteSpan) { return true; };
    const ProcedureReport report = bench.goOn(30);
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_FALSE(report.home);
    EXPECT_EQ(bench.truth().commandVelocity, 0) << "the stop arrives although the answers do not";
}

TEST_F(Failing, OneLostReplyChangesNothing) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -600, true);
    unsigned commands = 0;
    // Only replies to polls and queries are lost; a command that is sent only once might fail without its
    // reply.
    bench.bus.losesReply = [&](ByteSpan command) {
        const bool question = command.size() >= 4 && (command[2] == 0x13 || command[2] == 0x0E);
        return question && ++commands % 40 == 0;
    };
    const ProcedureReport report = bench.run(intent::Home{onLimit1()});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    expectZeroAt(bench, -600);
    bench.bus.expectNoViolations();
}

TEST_F(Failing, OneReplyThatSaysItIsOffEndsNothing) {
    ASSERT_TRUE(bench.enable());
    bench.putSwitch(Input::Limit1, -1'000, true);
    bench.begin(intent::Home{onLimit1()});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.settle();
    bench.sayOff();
    const Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(next));
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_FALSE(report.failure);
    expectZeroAt(bench, -1'000);
    bench.bus.expectNoViolations();
}

TEST_F(Failing, ASearchThatIsCancelledWhileItMayBeOffIsStopped) {
    ASSERT_TRUE(bench.enable());
    bench.begin(intent::Home{onLimit1()});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.settle();
    bench.sayOff();
    const std::size_t before = bench.bus.sent.size();
    bench.procedure->cancel();
    const Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(next)) << "a stop might switch it on";
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 17", before), 1U);
    expectQuiet();
}

TEST_F(Failing, ASearchThatWasNotAnsweredIsStopped) {
    ASSERT_TRUE(bench.enable());
    bench.bus.losesReply = [](ByteSpan command) { return command.size() >= 4 && command[2] == 0x19; };
    bench.begin(intent::Home{onLimit1()});
    while (bench.turn())
        if (bench.procedure->report().failure)
            bench.bus.losesReply = nullptr;
    EXPECT_EQ(*bench.procedure->report().failure, ProcedureFailure::Refused);
    bench.settle();
    expectQuiet();
}

TEST(Homing, IsRefusedWhereItCannotWork) {
    ServoBench bench(4);  // a limit pin of an SC is always an input
    ASSERT_TRUE(bench.enable());
    HomingRecipe recipe = slowRecipe();
    const auto why = [&] { return plan(intent::Home{recipe}, bench.module()).error(); };
    EXPECT_EQ(why(), Refusal::NothingToFind);
    recipe.onHomeSwitch = true;
    EXPECT_EQ(why(), Refusal::NothingToFind) << "a PIC-SERVO has no home switch";
    recipe.onLimit1 = true;
    recipe.velocity = 0;
    EXPECT_EQ(why(), Refusal::NoVelocity);
    recipe.velocity = 1;
    recipe.acceleration = 0;
    EXPECT_EQ(why(), Refusal::NoAcceleration);
    recipe.acceleration = 1;
    recipe.timeLimit = 0;
    EXPECT_EQ(why(), Refusal::NoSearchLimits);
    recipe.timeLimit = 1;
    EXPECT_NE(procedureFor(intent::Home{recipe}, bench.module()), nullptr);
    ASSERT_TRUE(bench.perform(intent::ControlIo{{false, false, false, true}}));
    EXPECT_EQ(why(), Refusal::LimitIsOutput);
    EXPECT_EQ(procedureFor(intent::Home{recipe}, bench.module()), nullptr);
    recipe.onLimit1 = false;
    recipe.onLimit2 = true;
    ASSERT_TRUE(bench.perform(
        intent::Move{servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(6'554)}}));
    EXPECT_EQ(why(), Refusal::Moving);
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    EXPECT_EQ(why(), Refusal::ServoOff);
}

}  // namespace
}  // namespace nmc::test
