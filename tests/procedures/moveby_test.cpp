// SPDX-License-Identifier: GPL-3.0-or-later
// Relative moves that are repeated.
#include "model/intent/homingplan.h"
#include "module/stepperspeed.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

class MoveBy : public testing::Test {
protected:
    [[nodiscard]] static intent::MoveBy by(std::int32_t counts, unsigned rounds) {
        return {{counts, rounds}, ServoPace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}};
    }
    /// Goals of all moves that were loaded, as sent: AA 01 n4 control position...
    [[nodiscard]] std::vector<std::int32_t> goals() const {
        std::vector<std::int32_t> all;
        for (const auto& sent : bench.bus.sent)
            if (sent.bytes.size() == 17 && sent.bytes[2] == 0xD4)
                all.push_back(static_cast<std::int32_t>(sent.bytes[4] | std::uint32_t{sent.bytes[5]} << 8U |
                                                        std::uint32_t{sent.bytes[6]} << 16U |
                                                        std::uint32_t{sent.bytes[7]} << 24U));
        return all;
    }
    ServoBench bench;
};

TEST_F(MoveBy, MovesFromGoalToGoal) {
    ASSERT_TRUE(bench.enable());
    // Weak gains without Ki: if each move began where the motor is, its errors would add up.
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{20, 500, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    bench.set(sim::Input::Friction, 0.02);
    const ProcedureReport report = bench.run(by(250, 4));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.round, 4U);
    EXPECT_EQ(report.rounds, 4U);
    const auto all = goals();
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[1] - all[0], 250);
    EXPECT_EQ(all[3] - all[0], 750);
    EXPECT_GT(std::abs(bench.truth().positionError), 2) << "the motor itself is not there";
    EXPECT_EQ(bench.truth().commandPosition, all[3]);
    bench.bus.expectNoViolations();
}

TEST_F(MoveBy, BeginsAtTheGoalOfTheMoveBefore) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{20, 500, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    bench.set(sim::Input::Friction, 0.02);
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::Trapezoid{Counts(1'000), CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}}));
    bench.bus.runFor(3s);
    bench.take();
    ASSERT_NE(bench.truth().position, 1'000);
    EXPECT_EQ(bench.run(by(-100, 1)).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.truth().commandPosition, 900);
}

TEST_F(MoveBy, GoesBackAndForthAndPauses) {
    ASSERT_TRUE(bench.enable());
    intent::MoveBy wanted = by(300, 2);
    wanted.moves.backAndForth = true;
    wanted.moves.pause = 0.5;
    std::vector<TimePoint> starts;
    const TimePoint began = bench.bus.now;
    const ProcedureReport report = bench.run(wanted);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.round, 2U);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::Pausing) == 1);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{300, 0, 300, 0}));
    EXPECT_GT(toSeconds(bench.bus.now - began), 1.5) << "there are three pauses";
    EXPECT_NEAR(bench.truth().position, 0, 2);
    bench.bus.expectNoViolations();
}

/// It stands on limit switch 1 at first, which it must be able to leave.
TEST_F(MoveBy, ArmsTheLimitStopThatIsDueOnceTheMotorHasLeftASwitch) {
    bench.putSwitch(sim::Input::Limit1, 100, true);
    ASSERT_TRUE(bench.enable());
    bench.module().limitStop.eachMotion = true;
    ASSERT_TRUE(bench.perform(*limitStopDue(bench.module())));
    ASSERT_FALSE(bench.module().homing.onLimit1());
    EXPECT_EQ(bench.run(by(300, 3)).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{300, 600, 900}));
    EXPECT_TRUE(bench.module().homing.onLimit1());
    EXPECT_TRUE(bench.module().homing.onLimit2());
    bench.bus.expectNoViolations();
}

TEST_F(MoveBy, CancelStopsIt) {
    ASSERT_TRUE(bench.enable());
    bench.begin(by(20'000, 3));
    bench.turn();
    for (int i = 0; i < 30; ++i)
        bench.turn();
    ASSERT_GT(bench.truth().commandVelocity, 0.5);
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
    EXPECT_EQ(goals().size(), 1U);
    bench.bus.expectNoViolations();
}

TEST_F(MoveBy, AnyOtherStopEndsItAndIsLeftAsItIs) {
    ASSERT_TRUE(bench.enable());
    bench.begin(by(20'000, 3));
    for (int i = 0; i < 30; ++i)
        bench.turn();
    ASSERT_EQ(bench.bus.perform(
                  {{ModuleIndex(0), ServoCommand(servo::StopMotor{true, servo::StopManner::Abruptly, {}})}}),
              bus::Outcome::Done);
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.bus.sends("AA 01 05", before), 0U);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
    EXPECT_EQ(goals().size(), 1U);
}

TEST_F(MoveBy, ATripFailsItAndNothingIsSwitchedOnAgain) {
    ASSERT_TRUE(bench.enable(200));
    bench.set(sim::Input::TravelMax, 700.0);
    const ProcedureReport report = bench.run(by(500, 3));
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::WentOff);
    EXPECT_EQ(report.round, 2U);
    EXPECT_FALSE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(MoveBy, OneReplyThatSaysItIsOffEndsNothing) {
    ASSERT_TRUE(bench.enable());
    bench.begin(by(500, 2));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.settle();
    bench.sayOff();
    const Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(next));
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Done);
    EXPECT_EQ(goals().size(), 2U);
}

TEST_F(MoveBy, ALinkInDoubtEndsIt) {
    ASSERT_TRUE(bench.enable());
    bench.begin(by(20'000, 3));
    for (int i = 0; i < 30; ++i)
        bench.turn();
    bench.procedure->onLinkSuspect();
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.failure, ProcedureFailure::LinkSuspect);
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
}

TEST_F(MoveBy, BeyondTheChipsRangeNothingIsSent) {
    ASSERT_TRUE(bench.enable());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(intent::MoveBy{{0x7FFFFFFF}, ServoPace{CountsPerTick(1), CountsPerTickSquared(1)}});
    bench.module().apply(bus::CommandExecuted{
        ModuleIndex(0), bench.bus.now,
        ServoCommand(servo::StopMotor{true, servo::StopManner::Here, Counts(0x7FFFFF00)})});
    Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    ASSERT_TRUE(std::holds_alternative<Procedure::Send>(next)) << "only a stop is sent, and no load";
    EXPECT_EQ(std::get<Procedure::Send>(next).orders.size(), 1U);
    EXPECT_EQ(bench.procedure->report().failure, ProcedureFailure::TravelLimit);
    EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 0U);
}

TEST_F(MoveBy, IsRefusedWhereItCannotWork) {
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(plan(by(1, 1), bench.module()).error(), Refusal::ServoOff);
    EXPECT_EQ(plan(by(0, 1), bench.module()).error(), Refusal::StepTooShort);
    EXPECT_EQ(procedureFor(by(1, 1), bench.module()), nullptr);
}

/// A PIC-STEP that is switched on; its unit of speed is 25 steps/s.
class StepperMoveBy : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bench.connect());
        bench.settle();
        ASSERT_TRUE(bench.perform(
            stepperintent::SetParameters{{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0}}));
        ASSERT_TRUE(bench.perform(intent::Enable{}));
    }
    [[nodiscard]] static intent::MoveBy by(std::int32_t counts, unsigned rounds) {
        return {{counts, rounds}, bus::StepperPace{40, 4}};
    }
    ProcedureBench bench{{{ModuleType::Stepper, 1}}};
};

TEST_F(StepperMoveBy, MovesThatFarAsOftenAsAskedFor) {
    const std::int64_t start = bench.stepperTruth().position;
    const ProcedureReport report = bench.run(by(-250, 3));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.round, 3U);
    EXPECT_EQ(bench.stepperTruth().position, start - 750);
    EXPECT_EQ(bench.bus.sends("AA 01 D4"), 0U) << "a servo's move would look like this";
    bench.bus.expectNoViolations();
}

TEST_F(StepperMoveBy, GoesBackAndForthAndPauses) {
    const std::int64_t start = bench.stepperTruth().position;
    intent::MoveBy wanted = by(100, 2);
    wanted.moves.backAndForth = true;
    wanted.moves.pause = 0.5;
    const TimePoint began = bench.bus.now;
    EXPECT_EQ(bench.run(wanted).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.stepperTruth().position, start);
    EXPECT_GE(bench.bus.now - began, 1'500ms) << "three pauses between four moves";
}

TEST_F(StepperMoveBy, ALimitSwitchOnItsWayEndsItForGood) {
    bench.begin(by(2'000, 5));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(bench.turn());
    bench.set(sim::Input::Limit1, 1);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::StoppedShort);
    EXPECT_EQ(report.round, 1U);
    EXPECT_EQ(bench.stepperTruth().stepRate, 0);
    EXPECT_LT(bench.stepperTruth().position, 2'000);
    bench.bus.expectNoViolations();
}

TEST_F(StepperMoveBy, AMoveThatIsNotItsOwnEndsIt) {
    bench.begin(by(2'000, 5));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.settle();
    // Table 4 of DS-S: a change from a trapezoidal move to a velocity profile needs all three loaded.
    stepper::LoadTrajectory run;
    run.timer = StepperSpeed(stepper::SpeedMode::X1).timerFor(1'000);
    run.speed = std::uint8_t(40);
    run.accelerationTime = std::uint8_t(4);
    ASSERT_EQ(bench.bus.perform(
                  {{ModuleIndex(0), StepperCommand(run)}, {ModuleIndex(0), StepperCommand(StartMotion{})}}),
              bus::Outcome::Done);
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    EXPECT_NE(bench.stepperTruth().stepRate, 0) << "the motion that has taken over goes on";
}

TEST_F(StepperMoveBy, IsRefusedWhereItCannotWork) {
    EXPECT_EQ(plan(by(0, 1), bench.module()).error(), Refusal::StepTooShort);
    const intent::MoveBy servos{{10}, ServoPace{CountsPerTick(1 << 16), CountsPerTickSquared(100)}};
    EXPECT_EQ(plan(servos, bench.module()).error(), Refusal::NotAServo);
    bench.set(sim::Input::Limit1, 1);
    bench.settle();
    EXPECT_EQ(plan(by(10, 1), bench.module()).error(), Refusal::Limit1Active);
    EXPECT_TRUE(plan(by(-10, 1), bench.module()));
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    EXPECT_EQ(plan(by(-10, 1), bench.module()).error(), Refusal::AmplifierOff);
    EXPECT_EQ(procedureFor(by(-10, 1), bench.module()), nullptr);
}

TEST_F(StepperMoveBy, GoesHomeOnlyWhereHomeIsKnown) {
    const intent::GoHome home{bus::StepperPace{40, 4}};
    EXPECT_EQ(plan(home, bench.module()).error(), Refusal::HomeUnknown);
    ASSERT_EQ(bench.run(by(120, 1)).stage, ProcedureStage::Done);
    ASSERT_TRUE(bench.perform(intent::SaveAsHome{}));
    bench.bus.runFor(1s);
    bench.take();
    ASSERT_TRUE(bench.module().home.place());
    ASSERT_EQ(bench.run(by(-500, 1)).stage, ProcedureStage::Done);
    ASSERT_TRUE(bench.perform(home));
    bench.bus.runFor(3s);
    EXPECT_EQ(bench.stepperTruth().position, 120);
    EXPECT_EQ(bench.stepperTruth().stepRate, 0);
}

}  // namespace
}  // namespace nmc::test
