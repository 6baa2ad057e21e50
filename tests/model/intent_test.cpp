// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/intent/intent.h"

#include <gtest/gtest.h>

#include "intents.h"
#include "model/intent/jog.h"
#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

const intent::Move kRun{
    servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(100), true}};

std::vector<std::string> payloads(const Intent& intent, const ModuleState& module) {
    std::vector<std::string> hex;
    const auto steps = plan(intent, module);
    EXPECT_TRUE(steps.has_value());
    if (steps)
        for (const bus::Order& step : *steps) {
            const Payload payload = encode(std::get<ServoCommand>(step.command));
            hex.push_back(toHex(ByteBuffer<1>{payload.commandByte()}) +
                          (payload.data.empty() ? "" : " " + toHex(payload.data)));
        }
    return hex;
}

using Hex = std::vector<std::string>;

TEST(Plan, GoesToAPositionByLoadThenStart) {
    // 20 000 = 0x4E20, 8 counts/tick = 0x00080000, 1311 = 0x51F; control: position, velocity, acceleration,
    // servo.
    EXPECT_EQ(payloads(kMove, holdingServo()), (Hex{"D4 17 20 4E 00 00 00 00 08 00 1F 05 00 00", "05"}));
}

TEST(Plan, RunsInReverseByLoadThenStart) {
    // control: velocity, acceleration, servo, velocity profile, reverse = 0x76.
    EXPECT_EQ(payloads(kRun, holdingServo()), (Hex{"94 76 00 00 01 00 64 00 00 00", "05"}));
}

TEST(Plan, EnablesWithOneStopThatHoldsAndSetsTheAmplifier) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1, stopWith(servo::StopManner::MotorOff, false)));
    module.apply(sampleOf(1, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::Enable{}, module), (Hex{"17 05", "0B"}));
}

/// Its speeds, limits and home would be numbers of another chip.
TEST(Plan, OnlyStopsAModuleOfAnotherTypeThanTheMachineExpects) {
    ModuleState module = holdingServo();
    module.home.found(0, TimePoint{});
    const std::vector<Intent> stops{intent::StopSmoothly{}, intent::StopAbruptly{}, intent::MotorOff{}};
    const std::vector<Intent> others{kMove,
                                     kRun,
                                     intent::LoadMove{kTrapezoid},
                                     intent::GoHome{ServoPace{}},
                                     intent::Home{},
                                     intent::Enable{},
                                     intent::ApplyGains{},
                                     intent::ResetPosition{},
                                     intent::SetAmplifier{true},
                                     intent::Direct{ServoCommand(servo::SetGain{})}};
    module.expected = ModuleIdentity{ModuleType::Stepper, 1};
    for (const Intent& stop : stops)
        EXPECT_EQ(refusalOf(stop, module), std::nullopt) << stop.index();
    for (const Intent& other : others)
        EXPECT_EQ(refusalOf(other, module), Refusal::OtherType) << other.index();
    EXPECT_EQ(whyNot(IntentKind::Hold, module), Refusal::OtherType);
    module.expected = ModuleIdentity{ModuleType::Servo, 1};
    for (const Intent& other : others)
        EXPECT_NE(refusalOf(other, module), Refusal::OtherType) << other.index();
    EXPECT_EQ(refusalOf(kMove, module), std::nullopt) << "versions of one type count alike";
}

TEST(Plan, RefusesToEnableWithoutGainsThatHold) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::GainsUnknown);
    module.apply(executedAt(1, servo::SetGain{}));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::GainsUnknown);
}

/// The first step of tuning by hand (DS-V 4.3): the servo brakes while the shaft is turned by hand.
TEST(Plan, EnablesWithoutKpWhereKdActs) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    servo::SetGain braking;
    braking.kd = 100;
    braking.ol = 255;
    module.apply(executedAt(1, braking));
    EXPECT_EQ(payloads(intent::Enable{}, module), (Hex{"17 05", "0B"}));
    braking.kd = 0;
    module.apply(executedAt(2, braking));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::GainsUnknown);
}

TEST(Plan, RefusesToEnableWithoutMotorPower) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError, 0));
    EXPECT_EQ(refusalOf(intent::Enable{}, module), Refusal::NoPower);
}

TEST(Plan, RefusesAMoveWhileAServoIsOff) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(refusalOf(kMove, module), Refusal::ServoOff);
    EXPECT_EQ(refusalOf(kRun, module), Refusal::ServoOff);
    // A stop would switch it on (protocol.md 2).
    EXPECT_EQ(refusalOf(intent::StopAbruptly{}, module), Refusal::ServoOff);
    EXPECT_EQ(refusalOf(intent::StopSmoothly{}, module), Refusal::ServoOff);
}

TEST(Plan, RefusesATrapezoidAndAZeroInMotionButTakesAVelocity) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1, trapezoid(20'000, 8 << 16, 1311)));
    module.apply(executedAt(1, StartMotion{}));
    module.apply(sampleOf(1.1, kPower, kServoOn));
    EXPECT_EQ(refusalOf(kMove, module), Refusal::Moving);
    EXPECT_EQ(refusalOf(intent::ResetPosition{}, module), Refusal::Moving);
    EXPECT_TRUE(
        plan(kRun, module).has_value());  // DS-V 4.4: velocity mode may be entered in the middle of a move
}

TEST(Plan, RefusesAMoveThatCouldNeverMove) {
    servomotion::Trapezoid move = kTrapezoid;
    move.acceleration = CountsPerTickSquared(0);
    EXPECT_EQ(refusalOf(intent::Move{move}, holdingServo()), Refusal::NoAcceleration);
    move = kTrapezoid;
    move.velocity = CountsPerTick(0);
    EXPECT_EQ(refusalOf(intent::Move{move}, holdingServo()), Refusal::NoVelocity);
}

TEST(Plan, StopsAbruptlyWhereASmoothStopCouldNotSlowDown) {
    ModuleState module = holdingServo();
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 05"});
    servo::LoadTrajectory waiting = velocityMode(1 << 16, 100);
    waiting.startNow = false;
    module.apply(executedAt(1, waiting));
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 05"}) << "nothing has started yet";
    module.apply(executedAt(2, StartMotion{}));
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 09"});
    waiting.acceleration = CountsPerTickSquared(0);
    module.apply(executedAt(3, waiting));
    module.apply(executedAt(4, stopWith(servo::StopManner::Abruptly)));
    EXPECT_EQ(payloads(intent::StopSmoothly{}, module), Hex{"17 09"}) << "neither has changed it";
}

TEST(Plan, SwitchesTheMotorOffWhateverIsBelieved) {
    EXPECT_EQ(payloads(intent::MotorOff{}, servoModule()), Hex{"17 02"});
}

TEST(Plan, SendsThirteenGainBytesToEarlierVersions) {
    servo::SetGain gains;
    gains.kp = 1;
    gains.db = std::uint8_t{5};
    ModuleState old = servoModule(3);
    old.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::ApplyGains{gains}, old), Hex{"D6 01 00 00 00 00 00 00 00 00 00 00 00 01"});
    ModuleState present = servoModule(4);
    present.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(payloads(intent::ApplyGains{gains}, present),
              Hex{"E6 01 00 00 00 00 00 00 00 00 00 00 00 01 05"});
}

TEST(Plan, AsksNothingOfASilentModuleButToSwitchOff) {
    ModuleState module = holdingServo();
    module.silent = true;
    EXPECT_EQ(refusalOf(kMove, module), Refusal::Unresponsive);
    EXPECT_EQ(refusalOf(intent::ClearStickyBits{}, module), Refusal::Unresponsive);
    EXPECT_TRUE(plan(intent::MotorOff{}, module).has_value());
}

TEST(Plan, KnowsNoCommandsForOtherModules) {
    ModuleState module = holdingServo();
    module.info.identity = {ModuleType::Adc, 1};
    EXPECT_EQ(refusalOf(kMove, module), Refusal::NotAServo);
    EXPECT_EQ(refusalOf(intent::MotorOff{}, module), Refusal::NotAServo);
}

TEST(Plan, LoadsNowAndStartsLater) {
    EXPECT_EQ(payloads(intent::LoadMove{kTrapezoid}, holdingServo()),
              (Hex{"D4 17 20 4E 00 00 00 00 08 00 1F 05 00 00"}));
    EXPECT_EQ(payloads(intent::LoadMove{kRun.motion}, holdingServo()),
              (Hex{"94 76 00 00 01 00 64 00 00 00"}));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, holdingServo()), Refusal::NothingLoaded);
    ModuleState module = holdingServo();
    const auto steps = plan(intent::LoadMove{kTrapezoid}, module);
    ASSERT_TRUE(steps);
    module.apply(executedAt(5, std::get<ServoCommand>(steps->front().command)));
    EXPECT_TRUE(module.loadWaiting);
    EXPECT_FALSE(module.moving());
    EXPECT_EQ(payloads(intent::StartLoaded{}, module), (Hex{"05"}));
}

/// DS-V 5.2, Load Trajectory: without the servo bit, the start switches the servo off and drives the motor.
TEST(Plan, StartsALoadedPwmValueWhereOneMayBeDriven) {
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{200};
    ModuleState module = holdingServo();
    module.apply(executedAt(1, pwm));
    ASSERT_TRUE(module.loadWaiting);
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::ServoOn);
    module.apply(executedAt(2, stopWith(servo::StopManner::MotorOff)));
    module.apply(sampleOf(2.1, kMoveDone | kPosError | kPower, 0));
    module.apply(executedAt(3, pwm));
    EXPECT_EQ(payloads(intent::StartLoaded{}, module), (Hex{"05"}));
    module.rights = OperatorRights{.moves = true};
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::OperatorMode);
}

/// DS-V 5.2, Load Trajectory: what is not loaded is as before. The stop has set the velocity to 0.
TEST(Plan, StartsNoLoadThatCouldNeverMove) {
    servo::LoadTrajectory load;
    load.position = Counts(20'000);
    ModuleState module = holdingServo();
    module.apply(executedAt(1, load));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::NoVelocity);
    load.velocity = kTrapezoid.velocity;
    module.apply(executedAt(2, load));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::NoAcceleration) << "none was ever loaded";
    load.acceleration = kTrapezoid.acceleration;
    module.apply(executedAt(3, load));
    EXPECT_EQ(payloads(intent::StartLoaded{}, module), (Hex{"05"}));
    load.velocity.reset();
    load.acceleration.reset();
    module.apply(executedAt(4, stopWith(servo::StopManner::Abruptly)));
    module.apply(executedAt(5, load));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::NoVelocity);
}

/// DS-V 5.2, footnote of Load Trajectory: the goal is at most 0x7FFFFFFF = 2 147 483 647 away. From
/// 1 500 000 000, that is -647 483 647.
TEST(Plan, RefusesAGoalThatIsTooFarAway) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(1, kMoveDone | kPower, kServoOn, 1'500'000'000));
    servomotion::Trapezoid move = kTrapezoid;
    for (const auto& [goal, refused] :
         {std::pair(-1'000'000'000, true), {-647'483'648, true}, {-647'483'647, false}}) {
        const auto refusal = refused ? std::optional(Refusal::TooFar) : std::nullopt;
        move.position = Counts(goal);
        EXPECT_EQ(refusalOf(intent::Move{move}, module), refusal) << goal;
        EXPECT_EQ(refusalOf(intent::LoadMove{move}, module), refusal) << goal;
        module.apply(executedAt(2, trapezoid(goal, 8 << 16, 1'311)));
        EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), refusal) << goal;
    }
    EXPECT_EQ(refusalOf(kRun, module), std::nullopt) << "it has no goal";
}

/// The goal that waits counts from the zero of before.
TEST(Plan, AnotherZeroForgetsWhatWasLoaded) {
    ModuleState module = holdingServo();
    module.apply(
        executedAt(5, std::get<ServoCommand>(plan(intent::LoadMove{kTrapezoid}, module)->front().command)));
    module.apply(executedAt(6, ResetPosition{}));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::NothingLoaded);
}

TEST(Plan, AStopUsesUpWhatWasLoaded) {
    ModuleState module = holdingServo();
    module.apply(
        executedAt(5, std::get<ServoCommand>(plan(intent::LoadMove{kTrapezoid}, module)->front().command)));
    module.apply(executedAt(6, stopWith(servo::StopManner::Abruptly, true)));
    EXPECT_EQ(refusalOf(intent::StartLoaded{}, module), Refusal::NothingLoaded);
}

TEST(Plan, StopsHereAtThePositionItHas) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(10, kMoveDone | kPower, kServoOn, 100));
    // Stop here and AMP_EN: 0x11, position 100 = 0x64 (protocol.md 4, golden frame).
    EXPECT_EQ(payloads(intent::StopHere{}, module), (Hex{"57 11 64 00 00 00"}));
    module.info.identity.version = 1;
    EXPECT_EQ(refusalOf(intent::StopHere{}, module), Refusal::VersionLacksIt);
}

/// The reported position is behind a motor that moves, and without a profile, it would be driven back there.
/// DS-V 5.2: AMP_EN and stop abruptly are 0x01 and 0x04.
TEST(Plan, StopsHereAbruptlyInMotion) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1, trapezoid(20'000, 8 << 16, 1'311)));
    module.apply(executedAt(1, StartMotion{}));
    module.apply(sampleOf(1.1, kPower, kServoOn, 100));
    EXPECT_EQ(payloads(intent::StopHere{}, module), Hex{"17 05"});
    module.apply(sampleOf(5, kMoveDone | kPower, kServoOn, 20'000));
    // 20 000 = 0x4E20.
    EXPECT_EQ(payloads(intent::StopHere{}, module), (Hex{"57 11 20 4E 00 00"}));
    // At its velocity, a run reports that the move is done.
    module.apply(executedAt(6, velocityMode(8 << 16, 1'311)));
    module.apply(sampleOf(7, kMoveDone | kPower, kServoOn, 30'000));
    EXPECT_EQ(payloads(intent::StopHere{}, module), Hex{"17 05"});
}

/// The position may be that of another module (link.md 2.4), for 2 s.
TEST(Plan, PlansNoGoalByADoubtfulPosition) {
    const intent::MoveBy step{{100}, ServoPace{kTrapezoid.velocity, kTrapezoid.acceleration}};
    ModuleState module = holdingServo();
    bus::Sample jump = sampleOf(10, kMoveDone | kPower, kServoOn, 3'386);
    jump.jumped = true;
    module.apply(jump);
    for (const Intent& wanted : {Intent(intent::StopHere{}), Intent(kMove), Intent(step)})
        EXPECT_EQ(refusalOf(wanted, module), Refusal::PositionUnknown) << wanted.index();
    EXPECT_EQ(refusalOf(kRun, module), std::nullopt) << "it has no goal";
    EXPECT_EQ(payloads(intent::StopAbruptly{}, module), Hex{"17 05"});
    module.apply(sampleOf(10.1, kPower, kServoOn, 3'386));
    EXPECT_EQ(payloads(intent::StopHere{}, module), Hex{"17 05"})
        << "in motion, the position does not matter";
    module.apply(sampleOf(12, kMoveDone | kPower, kServoOn, 3'386));
    // 3 386 = 0x0D3A.
    EXPECT_EQ(payloads(intent::StopHere{}, module), (Hex{"57 11 3A 0D 00 00"}));
    EXPECT_EQ(refusalOf(kMove, module), std::nullopt);
    EXPECT_EQ(refusalOf(step, module), std::nullopt);
}

/// Whether AMP_EN is high cannot be read, and a stop without it lets the motor coast.
TEST(Plan, AStopOfAServoThatAnotherHostLeftOnKeepsItsAmplifier) {
    ModuleState module = servoModule();
    module.attached();
    module.apply(sampleOf(1, kPower, kServoOn, 100));
    EXPECT_EQ(payloads(intent::StopAbruptly{}, module), Hex{"17 05"});
    EXPECT_EQ(payloads(intent::StopHere{}, module), Hex{"17 05"}) << "it moves";
    module.apply(sampleOf(1.5, kMoveDone | kPower, kServoOn, 100));
    EXPECT_EQ(payloads(intent::StopHere{}, module), (Hex{"57 11 64 00 00 00"}));
    module.apply(executedAt(2, servo::StopMotor{false, servo::StopManner::AmplifierOnly, {}}));
    EXPECT_EQ(payloads(intent::StopAbruptly{}, module), Hex{"17 04"}) << "it is known to be low";
}

/// The start would do nothing (docs/family.md). LIMIT1 is the forward one; `reverse` and counts are the
/// chip's.
TEST(Plan, NeitherHoldsNorStepsTowardsAClosedLimitOfAnSc) {
    constexpr std::uint8_t kLimit1 = 0x20;
    constexpr std::uint8_t kLimit2 = 0x40;
    ModuleState module = holdingServo();
    module.info.identity.version = kScVersion;
    servo::ScIoControl io;
    io.limitStop = servo::LimitStop::Abruptly;
    module.apply(executedAt(1, io));
    for (const std::uint8_t closed : {kLimit1, kLimit2}) {
        module.apply(sampleOf(2, static_cast<std::uint8_t>(kMoveDone | kPower | closed), kServoOn, 0));
        for (const bool reverse : {false, true}) {
            const bool towards = reverse == (closed == kLimit2);
            const auto refusal = towards ? std::optional(Refusal::LimitClosed) : std::nullopt;
            bus::HoldToMove hold;
            hold.velocity = kTrapezoid.velocity;
            hold.acceleration = kTrapezoid.acceleration;
            hold.reverse = reverse;
            EXPECT_EQ(whyNot(hold, module), refusal) << reverse;
            const intent::MoveBy step{{reverse ? -100 : 100},
                                      ServoPace{kTrapezoid.velocity, kTrapezoid.acceleration}};
            EXPECT_EQ(refusalOf(step, module), refusal) << reverse;
        }
    }
}

TEST(Plan, PwmIsForAServoThatIsOffAndNeedsTheAmplifier) {
    EXPECT_EQ(refusalOf(intent::DrivePwm{100, true}, holdingServo()), Refusal::ServoOn);
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    // Motor off with AMP_EN = 0x03, load PWM (bit 3) in reverse (bit 6) = 0x48, start.
    EXPECT_EQ(payloads(intent::DrivePwm{100, true}, module), (Hex{"17 03", "24 48 64", "05"}));
    module.apply(sampleOf(1, kMoveDone | kPosError, 0));
    EXPECT_EQ(refusalOf(intent::DrivePwm{100, true}, module), Refusal::NoPower);
}

TEST(Plan, TheAmplifierAloneIsAStopMotorWithoutAMotion) {
    EXPECT_EQ(payloads(intent::SetAmplifier{true}, holdingServo()), Hex{"17 01"});
    EXPECT_EQ(payloads(intent::SetAmplifier{false}, holdingServo()), Hex{"17 00"});
}

TEST(Plan, LimitPinsBecomeOutputs) {
    // Limit 1 output high, limit 2 input: bits 0 and 3 (DS-V 5.2).
    const servo::IoControl io{true, false, false, true};
    EXPECT_EQ(payloads(intent::ControlIo{io}, holdingServo()), Hex{"18 09"});
    ModuleState module = holdingServo();
    module.apply(executedAt(3, io));
    EXPECT_EQ(module.io, io);
    EXPECT_EQ(payloads(intent::SaveAsHome{}, module), Hex{"0C"});
}

}  // namespace
}  // namespace nmc
