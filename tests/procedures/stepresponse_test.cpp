// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses: what is sent, why they are refused, and how they end.
#include "model/procedure/stepsrun.h"

#include <limits>

#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

class StepResponse : public testing::Test {
protected:
    [[nodiscard]] static intent::StepResponse by(std::int32_t counts,
                                                 ResponseMethod method = ResponseMethod::Profile) {
        return {counts, method, 0.2};
    }
    [[nodiscard]] Refusal refusal(const intent::StepResponse& wanted) {
        const auto steps = plan(wanted, bench.module());
        EXPECT_FALSE(steps);
        EXPECT_EQ(procedureFor(wanted, bench.module()), nullptr);
        return steps ? Refusal::NotConnected : steps.error();
    }
    /// Number of loads, starts and stops of any kind, from this entry of `sent` on.
    [[nodiscard]] std::size_t motions(std::size_t from) const {
        return bench.bus.sends("AA 01 D4", from) + bench.bus.sends("AA 01 05", from) +
               bench.bus.sends("AA 01 17", from) + bench.bus.sends("AA 01 57", from);
    }
    /// Switches the servo on and makes the position that it holds known.
    [[nodiscard]] bool hold(std::uint16_t positionErrorLimit = 4'000) {
        return bench.enable(positionErrorLimit) && bench.perform(intent::StopHere{});
    }
    [[nodiscard]] bool applyGains(std::uint16_t kp, std::uint16_t kd, std::uint16_t errorLimit) {
        return bench.perform(intent::ApplyGains{{kp, kd, 0, 0, 255, 0, errorLimit, 1, std::uint8_t{0}}});
    }
    /// It is a CMC or SC, which steps by Stop Here and reports its position error.
    [[nodiscard]] bool later() { return hasPathBuffer(bench.module().info.identity); }
    ServoBench bench;
};

TEST_F(StepResponse, JumpsInOneTickAndEndsHolding) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(1'000));
    bench.settle();
    const std::int32_t from = 1'000;
    const std::size_t before = bench.bus.sent.size();
    std::vector<double> commands;
    bench.bus.onTime = [&] { commands.push_back(bench.truth().commandPosition); };
    const ProcedureReport report = bench.run(by(100));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.step);
    EXPECT_EQ(report.step->from, from);
    EXPECT_EQ(report.step->goal, from + 100);
    EXPECT_EQ(report.step->gains.kp, 200);
    for (const double command : commands)
        EXPECT_TRUE(command == from || command == from + 100) << command << ": no profile in between";
    EXPECT_TRUE(bench.truth().servoOn);
    EXPECT_EQ(bench.truth().commandPosition, from + 100);
    EXPECT_NEAR(bench.truth().position, from + 100, 3);
    if (!later()) {
        EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 1U);
        EXPECT_EQ(bench.bus.sends("AA 01 05 06", before), 1U);
    }
    EXPECT_EQ(bench.bus.sends("AA 01 17 05", before), 1U)
        << "an abrupt stop with the amplifier on leaves no velocity loaded";
    EXPECT_EQ(bench.bus.sends("AA 01 57 11 4C 04 00 00", before), later() ? 2U : 1U)
        << "this is Stop Here at 1100";
    bench.bus.expectNoViolations();
}

/// CMC and SC can be given at most 1280 counts per tick, and would keep that velocity (docs/family.md).
TEST(StepResponseOfLaterChips, StopsHereInsteadOfAProfile) {
    for (const std::uint8_t version : {kPathVersion, kScVersion}) {
        SCOPED_TRACE(int{version});
        ServoBench bench(version);
        ASSERT_TRUE(bench.enable());
        ASSERT_TRUE(bench.perform(intent::StopHere{}));
        const std::size_t before = bench.bus.sent.size();
        std::int32_t from = 0;
        for (const std::int32_t counts : {100, -1'280, 2'000}) {
            std::vector<double> commands;
            bench.bus.onTime = [&] { commands.push_back(bench.truth().commandPosition); };
            const ProcedureReport report =
                bench.run(intent::StepResponse{counts, ResponseMethod::Profile, 0.2});
            ASSERT_EQ(report.stage, ProcedureStage::Done) << counts;
            ASSERT_TRUE(report.step);
            EXPECT_EQ(report.step->method, ResponseMethod::StopHere);
            const std::int32_t goal = from + counts;
            for (const double command : commands)
                EXPECT_TRUE(command == from || command == goal) << counts << ": " << command;
            EXPECT_EQ(bench.truth().commandPosition, goal);
            from = goal;
        }
        EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 0U);
        bench.bus.expectNoViolations();
    }
}

TEST_F(StepResponse, StopsHereWithoutAnyProfile) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    const ProcedureReport report = bench.run(by(-100, ResponseMethod::StopHere));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.step->goal, -100);
    EXPECT_EQ(bench.bus.sends("AA 01 57 11 9C FF FF FF", before), 2U)
        << "once to jump to -100, once to hold there";
    EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 0U);
    EXPECT_EQ(bench.truth().commandPosition, -100);
    bench.bus.expectNoViolations();
}

/// The record begins when the module latches the step, to within half a tick.
TEST_F(StepResponse, KnowsWhenItWasTaken) {
    for (const ResponseMethod method : {ResponseMethod::Profile, ResponseMethod::StopHere}) {
        ASSERT_TRUE(hold());
        std::optional<TimePoint> jumped;
        const double before = bench.truth().commandPosition;
        bench.bus.onTime = [&] {
            if (!jumped && bench.truth().commandPosition != before)
                jumped = bench.bus.now;
        };
        bench.begin(by(100, method));
        while (bench.procedure->report().stage == ProcedureStage::Preparing)
            bench.turn();
        while (!bench.procedure->report().over())
            bench.turn();
        ASSERT_TRUE(jumped && bench.procedure->report().step);
        // The tick after that of the command, and the interval at which the test looks: about half a
        // millisecond each.
        EXPECT_NEAR(toSeconds(*jumped - bench.procedure->report().step->at), 0.000'512, 0.001);
        bench.bus.onTime = {};
    }
}

TEST_F(StepResponse, LeavesNoVelocityLoaded) {
    ASSERT_TRUE(hold());
    ASSERT_EQ(bench.run(by(100)).stage, ProcedureStage::Done);
    EXPECT_FALSE(bench.module().loadWaiting);
    EXPECT_EQ(whyNot(IntentKind::StartLoaded, bench.module()), Refusal::NothingLoaded);
    // A move to 0 that another host sends all the same, without a velocity: the loaded velocity is 0.
    const std::vector<std::uint8_t> move{0xAA, 0x01, 0x54, 0x91, 0x00, 0x00, 0x00, 0x00, 0xE6};
    bench.bus.chain.hostSends(move, bench.bus.now);
    bench.bus.runFor(500ms);
    EXPECT_EQ(bench.truth().mode, sim::ServoMode::Trapezoidal);
    EXPECT_NEAR(bench.truth().position, 100, 5);
}

/// A position that is reported as held is exact to the count, even if the shaft is turning at that moment.
TEST_F(StepResponse, ComesRightAfterEnableWhereTheShaftStood) {
    ASSERT_TRUE(bench.enable());
    EXPECT_EQ(bench.module().goal(), 0);
    EXPECT_TRUE(plan(by(50), bench.module()));
    int known = 0;
    for (int load = 0; load < 40; ++load) {
        ASSERT_TRUE(bench.perform(intent::MotorOff{}));
        bench.set(sim::Input::Load, 0.0002 * load);  // N·m; friction holds 0.004
        ASSERT_TRUE(bench.perform(intent::Enable{}));
        if (const auto held = bench.module().goal()) {
            ++known;
            EXPECT_EQ(*held, bench.truth().commandPosition) << load;
        }
    }
    EXPECT_GE(known, 20);
    if (!later()) {
        EXPECT_LT(known, 40) << "CMC and SC report the position error, so there it is always known";
    }
}

TEST_F(StepResponse, IsRefusedWhereItCannotWork) {
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(refusal(by(100)), Refusal::ServoOff);
    ASSERT_TRUE(bench.enable(110));
    ASSERT_TRUE(bench.perform(intent::ResetPosition{}));
    if (!later()) {
        EXPECT_EQ(refusal(by(50)), Refusal::CommandUnknown);
    }
    ASSERT_TRUE(bench.perform(intent::StopHere{}));
    EXPECT_EQ(refusal(by(0)), Refusal::StepTooShort);
    EXPECT_EQ(refusal(by(2'001)), Refusal::StepTooLong);
    EXPECT_EQ(refusal(by(-2'001)), Refusal::StepTooLong);
    EXPECT_EQ(refusal(by(INT32_MIN)), Refusal::StepTooLong);
    // 97 + 9 + 4 = 110; one count more would be 111.
    EXPECT_TRUE(plan(by(97), bench.module()));
    EXPECT_EQ(refusal(by(98)), Refusal::StepWouldTrip);
    EXPECT_EQ(refusal(by(-98)), Refusal::StepWouldTrip);
    for (const double seconds : {0.0, -1.0, 0.01, 3.1, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(refusal({50, ResponseMethod::Profile, seconds}), Refusal::RecordTime) << seconds;
    const auto holdAt = [this](std::int32_t position) {
        bench.module().apply(bus::CommandExecuted{
            ModuleIndex(0), bench.bus.now,
            ServoCommand(servo::StopMotor{true, servo::StopManner::Here, Counts(position)})});
    };
    holdAt(0x7FFF'FFC0);
    EXPECT_EQ(refusal(by(64)), Refusal::GoalOutOfRange);
    EXPECT_TRUE(plan(by(63), bench.module()));
    holdAt(-0x7FFF'FFC0);
    EXPECT_EQ(refusal(by(-64)), Refusal::GoalOutOfRange);
    bench.module().gains.reset();
    EXPECT_EQ(refusal(by(50)), Refusal::GainsUnknown);
    bench.module().silent = true;
    EXPECT_EQ(refusal(by(50)), Refusal::Unresponsive);
}

/// A stop at rest, as Esc sends it, does not change the command position: what is held remains known.
TEST_F(StepResponse, BeginsWhereTheMotorIsHeldBehindAStopAtRest) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::Trapezoid{Counts(1'000), CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}}));
    bench.bus.runFor(2s);
    bench.take();
    for (const Intent& stop : {Intent(intent::StopSmoothly{}), Intent(intent::StopAbruptly{})}) {
        ASSERT_TRUE(bench.perform(stop));
        bench.bus.runFor(1s);
        bench.take();
        ASSERT_EQ(bench.module().goal(), 1'000);
        EXPECT_EQ(bench.truth().commandPosition, 1'000);
    }
    const ProcedureReport report = bench.run(by(100));
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.step->from, 1'000);
    EXPECT_EQ(report.step->goal, 1'100);
}

/// A load keeps the shaft off its command position: if steps began at the shaft, each would begin lower.
TEST_F(StepResponse, ThereAndBackUnderALoadEndWhereTheyBegan) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{20, 500, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    bench.set(sim::Input::Load, 0.1);
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::Trapezoid{Counts(1'000), CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}}));
    bench.bus.runFor(3s);
    bench.take();
    ASSERT_GT(std::abs(bench.truth().positionError), 5) << "the load pulls it off";
    for (int round = 0; round < 5; ++round) {
        ASSERT_EQ(bench.run(by(200)).stage, ProcedureStage::Done);
        EXPECT_EQ(bench.truth().commandPosition, 1'200);
        ASSERT_EQ(bench.run(by(-200, ResponseMethod::StopHere)).stage, ProcedureStage::Done);
        EXPECT_EQ(bench.truth().commandPosition, 1'000);
    }
    bench.bus.expectNoViolations();
}

TEST_F(StepResponse, IsRefusedWhileTheMotorMoves) {
    ASSERT_TRUE(hold());
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(1'311), false}}));
    EXPECT_EQ(refusal(by(50)), Refusal::Moving);
}

TEST(StepResponseOfVersion1, CannotStopHere) {
    ServoBench bench(1);
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(100));
    EXPECT_EQ(plan(intent::StepResponse{50, ResponseMethod::StopHere, 0.2}, bench.module()).error(),
              Refusal::VersionLacksIt);
    EXPECT_EQ(bench.run(intent::StepResponse{50, ResponseMethod::Profile, 0.2}).stage, ProcedureStage::Done);
}

TEST(StepResponseOfAStepper, IsRefused) {
    ProcedureBench bench({{ModuleType::Stepper, 1}});
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(plan(intent::StepResponse{50, ResponseMethod::Profile, 0.2}, bench.module()).error(),
              Refusal::NotAServo);
}

TEST_F(StepResponse, DoesNotBeginWhileTheMotorSwings) {
    ASSERT_TRUE(hold());
    // Each time it is looked at, the motor is somewhere else.
    std::int32_t swing = 0;
    bench.onTurn = [&](Procedure&) { bench.module().latest->position = (swing ^= 40); };
    const std::size_t before = bench.bus.sent.size();
    const ProcedureReport report = bench.run(by(100), 5);
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::NotStill);
    EXPECT_FALSE(report.step);
    EXPECT_EQ(motions(before), 0U) << "nothing was started, so nothing is stopped";
}

TEST_F(StepResponse, ATripFailsItAndNothingIsSwitchedOnAgain) {
    ASSERT_TRUE(hold());
    ASSERT_TRUE(applyGains(3'000, 100, 130));  // hardly damped: it overshoots by far
    const ProcedureReport report = bench.run(by(110));
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::WentOff);
    EXPECT_FALSE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(StepResponse, OneThatSwingsWiderAndWiderIsSwitchedOff) {
    ASSERT_TRUE(hold());
    ASSERT_TRUE(applyGains(30'000, 0, 16'000));
    intent::StepResponse wanted = by(50);
    wanted.record = 2;
    const ProcedureReport report = bench.run(wanted);
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::Unstable);
    EXPECT_FALSE(bench.truth().servoOn);
    EXPECT_FALSE(bench.module().switchedItselfOff) << "it was switched off by a command";
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.truth().pwm, 0);
}

TEST_F(StepResponse, OneThatIsPushedTooFarIsHeldAndStaysOn) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(100));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.turn();
    bench.turn();
    bench.onTurn = [&](Procedure&) {
        if (bench.bus.sends("AA 01 17 05", before) == 0)
            bench.module().latest->position = 205;
    };
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
    EXPECT_EQ(bench.bus.sends("AA 01 17 05", before), 1U);
    EXPECT_TRUE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(StepResponse, OneThatGoesTheWrongWayIsHeld) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(100));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.turn();
    bench.turn();
    bench.onTurn = [&](Procedure&) {
        if (bench.bus.sends("AA 01 17 05", before) == 0)
            bench.module().latest->position = -30;
    };
    EXPECT_EQ(bench.goOn(5).failure, ProcedureFailure::TravelLimit);
    EXPECT_EQ(bench.bus.sends("AA 01 17 05", before), 1U);
}

TEST_F(StepResponse, CancelHoldsIt) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    intent::StepResponse wanted = by(100);
    wanted.record = 3;
    bench.begin(wanted);
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    for (int i = 0; i < 5; ++i)
        bench.turn();
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 01 17 05", before), 1U);
    EXPECT_TRUE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(StepResponse, CancelledBeforeTheStepSendsNothing) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(100));
    bench.turn();
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(motions(before), 0U);
}

TEST_F(StepResponse, AnyOtherStopEndsItAndIsLeftAsItIs) {
    ASSERT_TRUE(hold());
    intent::StepResponse wanted = by(100);
    wanted.record = 3;
    bench.begin(wanted);
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    for (int i = 0; i < 5; ++i)
        bench.turn();
    ASSERT_EQ(bench.bus.perform(
                  {{ModuleIndex(0), ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})}}),
              bus::Outcome::Done);
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(motions(before), 0U);
}

TEST_F(StepResponse, AStopOfAllThatCancelsTheStepLeavesNothingToSend) {
    ASSERT_TRUE(hold());
    bench.begin(by(100));
    while (bench.procedure->report().stage == ProcedureStage::Preparing)
        bench.turn();
    ASSERT_TRUE(bench.bus.stopAll());
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(motions(before), 0U);
}

TEST_F(StepResponse, ALinkInDoubtEndsItWithAHold) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(100));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.turn();
    bench.procedure->onLinkSuspect();
    EXPECT_EQ(bench.goOn(5).failure, ProcedureFailure::LinkSuspect);
    EXPECT_EQ(bench.bus.sends("AA 01 17 05", before), 1U);
    EXPECT_TRUE(bench.truth().servoOn);
}

/// The position error limit is lowered while the procedure waits for standstill.
TEST_F(StepResponse, LooksAgainRightBeforeTheStep) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(1'000));
    bench.module().gains->el = 1'000;
    EXPECT_EQ(bench.goOn(5).failure, ProcedureFailure::Refused);
    EXPECT_EQ(motions(before), 0U);
}

}  // namespace
}  // namespace nmc::test
