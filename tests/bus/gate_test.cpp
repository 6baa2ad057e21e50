// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/gate.h"
#include "tests/bus/scriptedbus.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr std::uint8_t kMoveDone = 0x01;
constexpr std::uint8_t kPower = 0x08;

/// A belief, with a clock that advances by one millisecond with each message.
class Module {
public:
    explicit Module(ModuleIdentity identity = {ModuleType::Servo, 4})
        : belief({ModuleIndex(0), BusAddress(1), identity}) {}

    void status(std::uint8_t bits, std::uint8_t aux, std::int16_t velocity = 0,
                std::optional<std::int32_t> position = {}) {
        StatusReport report;
        report.items = StatusItems(0x3F);
        report.status = bits;
        report.aux = aux;
        report.velocity = velocity;
        report.position = position;
        belief.onStatus(report, m_now += 1ms);
    }
    void executed(const Order& order) {
        belief.onSent(order.command, m_now += 1ms);
        belief.onExecuted(order.command);
    }
    void wait(Duration time) { m_now += time; }
    void unanswered(const Order& order) { belief.onSent(order.command, m_now += 1ms); }
    [[nodiscard]] Permission permit(const Order& order) const { return bus::permit(belief, order.command); }
    /// The permission to start a trapezoidal move that has been loaded.
    [[nodiscard]] Permission permitMove() const {
        Module loaded = *this;
        loaded.executed(loadMove(0, 10));
        return loaded.permit(start(0));
    }
    [[nodiscard]] Permission permit(ServoCommand command) const { return bus::permit(belief, command); }

    Belief belief;

private:
    TimePoint m_now{};
};

[[nodiscard]] Module standing() {
    Module module;
    module.status(kMoveDone | kPower, kServoOn);
    return module;
}

TEST(Gate, LetsAStandingServoLoadAndStart) {
    Module module = standing();
    EXPECT_EQ(module.permit(loadMove(0, 10)), Permission::Allowed);
    EXPECT_EQ(module.permit(start(0)), Permission::Never) << "nothing loaded";
    module.executed(loadMove(0, 10));
    EXPECT_EQ(module.permit(start(0)), Permission::Allowed);
}

/// Its goal, 10 counts from the zero of before, would be somewhere else.
TEST(Gate, LetsNoLoadStartThatIsOlderThanTheZero) {
    Module module = standing();
    module.executed(loadMove(0, 10));
    module.executed(toServo(0, ResetPosition{}));
    module.status(kMoveDone | kPower, kServoOn);
    EXPECT_EQ(module.permit(start(0)), Permission::Never);
    module.executed(loadMove(0, 10));
    EXPECT_EQ(module.permit(start(0)), Permission::Allowed);
}

TEST(Gate, WantsToSeeAStatusFirst) {
    Module module;
    EXPECT_EQ(module.permitMove(), Permission::NeedsStatus);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::NeedsStatus);
    module = standing();
    module.executed(enable(0));
    EXPECT_EQ(module.permitMove(), Permission::NeedsStatus) << "older than the last motion command";
}

TEST(Gate, ForbidsWhatMustNotHappenInAMove) {
    Module module = standing();
    module.executed(loadMove(0, 10));
    module.executed(start(0));
    module.status(kPower, kServoOn);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::InMotion);
    EXPECT_EQ(module.permit(loadVelocity(0, 10, true)), Permission::Allowed);
    module.status(kMoveDone | kPower, kServoOn);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::Allowed);
    EXPECT_EQ(module.permit(start(0)), Permission::Never) << "used up";
}

/// DS-V 5.1, note 1; DS-S 5.1 Load Trajectory.
TEST(Gate, LetsALoadWaitForItsStartWhateverMoves) {
    Module module = standing();
    module.executed(loadMove(0, 10));
    module.executed(start(0));
    module.status(kPower, kServoOn, 1);
    EXPECT_EQ(module.permit(loadMove(0, 20)), Permission::Allowed);
    module.executed(loadMove(0, 20));
    EXPECT_EQ(module.permit(start(0)), Permission::InMotion);
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permit(start(0)), Permission::Allowed);
}

TEST(Gate, KnowsThatMoveDoneSaysNothingAtConstantVelocity) {
    Module module = standing();
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower, kServoOn, 1);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    module.executed(loadVelocity(0, 0, true));
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

TEST(Gate, CountsAnUnansweredStartAsMoving) {
    Module module = standing();
    module.unanswered(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    module.unanswered(enable(0));
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permitMove(), Permission::InMotion) << "the stop was not answered either";
    module.executed(enable(0));
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

TEST(Gate, DoesNotStartALoadThatWasNotAnswered) {
    Module module = standing();
    module.unanswered(loadMove(0, 10));
    EXPECT_EQ(module.permit(start(0)), Permission::Never);
    module.executed(loadMove(0, 10));
    module.unanswered(loadMove(0, 20));
    EXPECT_EQ(module.permit(start(0)), Permission::Never) << "it is not known which of the two is loaded";
}

TEST(Gate, ForbidsTrapezoidalStartNow) {
    servo::LoadTrajectory load;
    load.position = Counts(5);
    load.startNow = true;
    EXPECT_EQ(standing().permit(load), Permission::Never);
}

TEST(Gate, ForbidsThatASteppersLoadStartsAMoveToItsPosition) {
    Module stepper({ModuleType::Stepper, 1});
    stepper.belief.onExecuted(StepperCommand(stepper::SetParameters{}));
    stepper.status(kPower | 0x04, 0);
    const stepper::LoadTrajectory whole{Counts(100), std::uint8_t{10}, std::uint8_t{4},
                                        stepper::TimerCount{60'000, 40}};
    const auto starts = [&](bool position, bool profile) {
        stepper::LoadTrajectory load = partOf(whole, position, profile, profile, !profile);
        load.startNow = true;
        return bus::permit(stepper.belief, StepperCommand(load));
    };
    EXPECT_EQ(starts(true, true), Permission::Never) << "a trapezoid";
    EXPECT_EQ(starts(true, false), Permission::Never) << "without a ramp";
    EXPECT_EQ(starts(false, true), Permission::Allowed);
    EXPECT_EQ(starts(false, false), Permission::Allowed);
}

TEST(Gate, TakesACoastingMotorForMoving) {
    Module module;
    module.status(kMoveDone | kPower, 0, 3);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    module.status(kMoveDone | kPower, 0, 0);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

/// At two thirds of a count per tick, the velocity item is 0 in every third tick.
TEST(Gate, TakesAMotorThatCoastsSlowlyForMoving) {
    Module module;
    module.status(kMoveDone | kPower, 0, 0, 1'000);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
    module.status(kMoveDone | kPower, 0, 0, 1'002);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::InMotion);
    module.wait(10ms);
    module.status(kMoveDone | kPower, 0, 0, 1'003);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

/// At half a count per millisecond, no two statuses of a fast line differ by more than a count.
TEST(Gate, TakesAMotorThatCoastsSlowlyForMovingHoweverOftenItIsRead) {
    Module module;
    for (const std::int32_t position : {1'000, 1'000, 1'001, 1'001, 1'002, 1'002})
        module.status(kMoveDone | kPower, 0, 0, position);
    for (const std::int32_t position : {1'003, 1'003, 1'004, 1'004, 1'005, 1'005}) {
        module.status(kMoveDone | kPower, 0, 0, position);
        EXPECT_EQ(module.permitMove(), Permission::InMotion) << position;
    }
    for (int i = 0; i < 10; ++i)
        module.status(kMoveDone | kPower, 0, 0, 1'005);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

TEST(Gate, TakesNoRenamedPositionForAMotion) {
    Module module;
    module.status(kMoveDone | kPower, 0, 0, 1'000);
    module.executed(toServo(0, ResetPosition{}));
    module.status(kMoveDone | kPower, 0, 0, 0);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::Allowed);
}

TEST(Gate, TakesAPwmOutputForMoving) {
    Module module = standing();
    module.executed(loadPwm(0, 60));
    module.status(kMoveDone | kPower, 0, 0);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    module.executed(motorOff(0));
    module.status(kMoveDone | kPower, 0, 0);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

/// DS-V 5.1, notes 1 and 2.
TEST(Gate, StartsNoPwmOutputWhileTheServoMoves) {
    servo::LoadTrajectory waiting;
    waiting.servo = false;
    waiting.pwm = std::uint8_t{60};
    Module module = standing();
    EXPECT_EQ(module.permit(loadPwm(0, 60)), Permission::Allowed);
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower, kServoOn, 1);
    EXPECT_EQ(module.permit(loadPwm(0, 60)), Permission::InMotion);
    module.executed(toServo(0, waiting));
    EXPECT_EQ(module.permit(start(0)), Permission::InMotion);
    module.executed(motorOff(0));
    EXPECT_EQ(module.permit(loadPwm(0, 60)), Permission::Allowed) << "however the motor coasts";
    module.executed(toServo(0, waiting));
    EXPECT_EQ(module.permit(start(0)), Permission::Allowed);
}

TEST(Gate, KnowsThatHomingStopsByItself) {
    constexpr std::uint8_t kHoming = 0x80;
    servo::SetHoming homing;
    homing.onLimit1Change = homing.stopAbruptly = true;
    Module module = standing();
    module.executed(toServo(0, homing));
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower | kHoming, kServoOn, 1);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
    module.status(kMoveDone | kPower, kServoOn, 0);
    EXPECT_EQ(module.permitMove(), Permission::Allowed);
}

/// DS-V 4.5: after a reset, the servo is off. Its last status is from before, and no other one comes.
TEST(Gate, TakesNoModuleForMovingThatHasRestarted) {
    Module module = standing();
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower, kServoOn, 5);
    EXPECT_TRUE(module.belief.moving());
    module.belief.setRestarted();
    EXPECT_FALSE(module.belief.moving());
    EXPECT_FALSE(module.belief.mayMove());
}

/// The chip may have been told to capture home without stopping.
TEST(Gate, ReliesOnNoStopAtHomeThatMayHaveBeenReplaced) {
    constexpr std::uint8_t kHoming = 0x80;
    servo::SetHoming homing;
    homing.onLimit1Change = homing.stopAbruptly = true;
    Module module = standing();
    module.executed(toServo(0, homing));
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower | kHoming, kServoOn, 1);
    homing.stopAbruptly = false;
    module.unanswered(toServo(0, homing));
    module.status(kMoveDone | kPower, kServoOn, 1);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
}

/// Without a condition it cancels the search (protocol.md 2), whatever else it says: nothing ends the run.
TEST(Gate, KnowsThatASearchWithoutAConditionStopsNothing) {
    servo::SetHoming cancel;
    cancel.stopSmoothly = true;
    Module module = standing();
    module.executed(loadVelocity(0, 65'536, true));
    module.status(kMoveDone | kPower, kServoOn, 1);
    module.executed(toServo(0, cancel));
    module.status(kMoveDone | kPower, kServoOn, 1);
    EXPECT_EQ(module.permitMove(), Permission::InMotion);
}

TEST(Gate, ForbidsWhatTheVersionDoesNotHave) {
    Module old({ModuleType::Servo, 1});
    old.status(kMoveDone | kPower, kServoOn);
    servo::SetGain fourteen{};
    fourteen.db = 0;
    EXPECT_EQ(old.permit(fourteen), Permission::Never);
    EXPECT_EQ(old.permit(servo::SetGain{}), Permission::Allowed);
    EXPECT_EQ(old.permit(servo::StopMotor{true, servo::StopManner::Here, Counts(1)}), Permission::Never);
}

TEST(Gate, ForbidsTheOtherChipsCommands) {
    Module stepper({ModuleType::Stepper, 1});
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(stepper::SetOutputs{1})), Permission::Allowed);
    EXPECT_EQ(stepper.permit(servo::ClearStickyBits{}), Permission::Never);
    EXPECT_EQ(bus::permit(standing().belief, StepperCommand(stepper::SetOutputs{1})), Permission::Never);
}

TEST(Gate, ForbidsValuesOutsideTheDataSheet) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(0x8000'0000U);
    load.profile = servo::ProfileMode::Velocity;
    EXPECT_EQ(standing().permit(load), Permission::Never);
}

TEST(Gate, HoldsASteppersTrapezoidBackWhileItMoves) {
    constexpr std::uint8_t kMoving = 0x01;
    Module stepper({ModuleType::Stepper, 1});
    stepper::LoadTrajectory load;
    load.position = Counts(100);
    load.speed = std::uint8_t{10};
    stepper.status(kMoving | kPower | 0x04, 0);
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(load)), Permission::Never)
        << "before Set Parameters";
    stepper.belief.onExecuted(StepperCommand(stepper::SetParameters{}));
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(load)), Permission::Allowed) << "it is only loaded";
    stepper.belief.onSent(StepperCommand(load), TimePoint{});
    stepper.belief.onExecuted(StepperCommand(load));
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(StartMotion{})), Permission::InMotion);
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(stepper::SetParameters{})), Permission::Allowed);
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(ResetPosition{})), Permission::InMotion);
    stepper.status(kPower | 0x04, 0);
    EXPECT_EQ(bus::permit(stepper.belief, StepperCommand(StartMotion{})), Permission::Allowed);
}

TEST(Belief, RemembersThatAServoMayBeOn) {
    Module module;
    module.status(kMoveDone | kPower, 0);
    EXPECT_FALSE(module.belief.mayBeOn());
    module.unanswered(loadVelocity(0, 1, true));
    EXPECT_TRUE(module.belief.mayBeOn());
    EXPECT_FALSE(module.belief.on());
    module.status(kMoveDone | kPower, 0);
    EXPECT_FALSE(module.belief.mayBeOn());
    module.unanswered(toServo(0, servo::StopMotor{true, servo::StopManner::AmplifierOnly, {}}));
    EXPECT_FALSE(module.belief.mayBeOn());
    // DS-V 5.2, Stop Motor: bits 2, 3 and 4.
    for (const auto manner :
         {servo::StopManner::Abruptly, servo::StopManner::Smoothly, servo::StopManner::Here}) {
        module.unanswered(toServo(0, servo::StopMotor{true, manner, {}}));
        EXPECT_TRUE(module.belief.mayBeOn()) << static_cast<int>(manner);
        module.executed(motorOff(0));
        EXPECT_FALSE(module.belief.mayBeOn());
    }
}

/// What the watch at a travel limit needs to know of a run.
TEST(Belief, ExpectsTheFasterMotionAndTheLongerStopUntilAStartIsAnswered) {
    const auto load = [](std::uint32_t velocity, std::uint32_t acceleration, bool startNow) {
        servo::LoadTrajectory run;
        run.velocity = CountsPerTick(velocity);
        run.acceleration = CountsPerTickSquared(acceleration);
        run.profile = servo::ProfileMode::Velocity;
        run.startNow = startNow;
        return toServo(0, run);
    };
    Module module = standing();
    const auto expectRun = [&module](std::uint32_t velocity, std::uint32_t acceleration) {
        EXPECT_EQ(module.belief.servoRegisters().runningVelocity, CountsPerTick(velocity));
        EXPECT_EQ(module.belief.servoRegisters().runningAcceleration, CountsPerTickSquared(acceleration));
    };
    module.executed(load(40, 20, true));
    module.executed(load(30, 10, false));
    expectRun(40, 20);
    const Belief before = module.belief;
    module.unanswered(start(0));
    expectRun(40, 10);
    module.belief.onNotExecuted(before);
    expectRun(40, 20);
    module.executed(start(0));
    expectRun(30, 10);
    module.unanswered(load(50, 25, true));
    expectRun(50, 10);
}

/// Either tick may be the module's: the watches then assume the worse one.
TEST(Belief, DoesNotKnowTheServoRateUntilAnotherOneIsAnswered) {
    const auto gainsAt = [](std::uint8_t sr) {
        return toServo(0, servo::SetGain{200, 2000, 20, 200, 255, 0, 4000, sr, std::uint8_t{0}});
    };
    Module module = standing();
    module.executed(gainsAt(10));
    EXPECT_EQ(module.belief.servoRegisters().servoRate, 10);
    module.unanswered(gainsAt(10));
    EXPECT_EQ(module.belief.servoRegisters().servoRate, 10) << "it is the same";
    module.unanswered(gainsAt(1));
    EXPECT_EQ(module.belief.servoRegisters().servoRate, std::nullopt);
    module.executed(gainsAt(1));
    EXPECT_EQ(module.belief.servoRegisters().servoRate, 1);
}

// docs/family.md, Path points: 30 and 60 Hz without fast path, 60 and 120 Hz with it.

constexpr std::uint8_t kPathMode = 0x40;

[[nodiscard]] Module standingSc() {
    Module module({ModuleType::Servo, kScVersion});
    module.status(kMoveDone | kPower, kServoOn);
    return module;
}

[[nodiscard]] Order scControl(bool fastPath, bool stepAndDirection = false) {
    servo::ScIoControl control;
    control.fastPath = fastPath;
    control.stepAndDirection = stepAndDirection;
    return toServo(0, control);
}

TEST(Gate, LetsAStandingScFollowAPathAtARateThatItHas) {
    using servo::PathRate;
    Module module = standingSc();
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz30), Permission::Allowed);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Allowed);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz120), Permission::Never);
    module.executed(scControl(true));
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz30), Permission::Never);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Allowed);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz120), Permission::Allowed);
    module.unanswered(scControl(false));
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Never)
        << "it is not known which one applies";
    module.executed(scControl(false, true));
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Never)
        << "with step and direction outputs";
}

TEST(Gate, LetsNobodyElseFollowAPath) {
    using servo::PathRate;
    EXPECT_EQ(mayFollowPath(standing().belief, PathRate::Hz60), Permission::Never) << "version 4";
    Module module = standingSc();
    module.belief.attach();
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Never) << "left by another host";
    module = standingSc();
    module.status(kMoveDone | kPower, 0);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::Never) << "the servo is off";
    module = standingSc();
    module.status(kPower, kServoOn);
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::InMotion);
    module = standingSc();
    module.executed(enable(0));
    EXPECT_EQ(mayFollowPath(module.belief, PathRate::Hz60), Permission::NeedsStatus);
}

TEST(Gate, KeepsOtherMotionsFromAModuleOnAPath) {
    Module module = standingSc();
    EXPECT_EQ(module.permit(servo::AddPathPoints()), Permission::Never)
        << "points are not sent as a command of their own";
    module.executed(toServo(0, servo::AddPathPoints()));
    EXPECT_TRUE(module.belief.mayMove());
    module.status(kMoveDone | kPower, kServoOn | kPathMode);
    EXPECT_TRUE(module.belief.onPath());
    EXPECT_EQ(module.permit(loadVelocity(0, 65'536, true)), Permission::InMotion);
    EXPECT_EQ(module.permit(ResetPosition{}), Permission::InMotion);
    EXPECT_EQ(module.permit(motorOff(0)), Permission::Allowed);
    module.status(kPower, kServoOn);
    EXPECT_TRUE(module.belief.onPath()) << "its move is not done";
    module.status(kMoveDone | kPower, kServoOn);
    EXPECT_FALSE(module.belief.onPath());
    EXPECT_EQ(module.permit(loadVelocity(0, 65'536, true)), Permission::Allowed);
    module.executed(toServo(0, servo::AddPathPoints()));
    module.executed(enable(0));
    EXPECT_FALSE(module.belief.onPath()) << "any Stop Motor ends it";
}

}  // namespace

}  // namespace nmc::test
