// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/module/modulestate.h"

#include <gtest/gtest.h>

#include "model/module/linkstate.h"

#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

TEST(ModuleState, AServoThatNobodySwitchedOnIsOffAndNotAFault) {
    // After reset the chip sets pos_error (DS-V 4.5); interface.md: that is "Servo off", not a fault.
    ModuleState module = servoModule();
    EXPECT_EQ(module.activity(), Activity::Unknown);
    module.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::ServoOff);
    EXPECT_EQ(severityOf(module.activity()), Severity::Normal);
}

TEST(ModuleState, WithoutMotorPowerSaysSo) {
    ModuleState module = servoModule();
    module.apply(sampleOf(0, kMoveDone | kPosError, 0));
    EXPECT_EQ(module.activity(), Activity::NoPower);
}

TEST(ModuleState, HoldsAfterItWasSwitchedOnAlthoughPosErrorSticks) {
    const ModuleState module = holdingServo();
    EXPECT_TRUE(module.servoOn());
    EXPECT_EQ(module.activity(), Activity::Holding);
    EXPECT_FALSE(module.moving());
}

TEST(ModuleState, OneAnswerOfAnotherModuleIsNoTrip) {
    // Another host queries a module that is on; its answer arrives in place of the one from this module,
    // which is off.
    ModuleState module = servoModule();
    module.apply(sampleOf(0.0, kMoveDone | kPosError | kPower, 0));
    module.apply(sampleOf(0.1, kMoveDone | kPosError | kPower, kServoOn));
    module.apply(sampleOf(0.2, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::ServoOff);
    // Once it has been seen on twice, it counts as on.
    module.apply(sampleOf(0.3, kMoveDone | kPower, kServoOn));
    module.apply(sampleOf(0.4, kMoveDone | kPower, kServoOn));
    module.apply(sampleOf(0.5, kMoveDone | kPosError | kPower, 0));
    module.apply(sampleOf(0.6, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::Tripped);
}

TEST(ModuleState, ATrapezoidalMoveGoesThroughItsPhases) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, trapezoid(20'000, 8 << 16, 1311)));
    EXPECT_FALSE(module.moving()) << "loaded only";
    module.apply(executedAt(1.1, StartMotion{}));
    module.apply(sampleOf(1.1, kPower, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Accelerating);
    module.apply(sampleOf(1.4, kPower, kServoOn | kAccelDone));
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    module.apply(sampleOf(2.2, kPower, kServoOn | kAccelDone | kSlewDone));
    EXPECT_EQ(module.activity(), Activity::Decelerating);
    EXPECT_TRUE(module.moving());
    module.apply(sampleOf(2.5, kPower | kMoveDone, kServoOn | kAccelDone | kSlewDone, 20'000));
    EXPECT_EQ(module.activity(), Activity::Holding);
    EXPECT_FALSE(module.moving());
}

TEST(ModuleState, ConstantVelocityIsMotionAlthoughMoveDoneIsSet) {
    // DS-V 5.3: in velocity mode move_done is set once the goal velocity is reached.
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(2.0, kPower | kMoveDone, kServoOn));
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    EXPECT_TRUE(module.moving());
    module.apply(executedAt(3.0, stopWith(servo::StopManner::Smoothly)));
    module.apply(sampleOf(3.0, kPower, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Decelerating);
    module.apply(sampleOf(4.0, kPower | kMoveDone, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Holding);
}

/// DS-V 5.2, Stop Motor: of the manners, only "abruptly" and "smoothly" set the goal velocity to zero. A run
/// that is then started without a velocity has the one before.
TEST(ModuleState, OnlyTwoMannersOfStoppingTakeTheLoadedVelocityAway) {
    servo::LoadTrajectory again = velocityMode(0, 100);
    again.velocity.reset();
    for (const auto& [manner, counts] : {std::pair(servo::StopManner::MotorOff, 3),
                                         {servo::StopManner::Here, 3},
                                         {servo::StopManner::Abruptly, 0},
                                         {servo::StopManner::Smoothly, 0}}) {
        ModuleState module = holdingServo();
        module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
        module.apply(executedAt(2.0, stopWith(manner)));
        EXPECT_FALSE(module.loadWaiting);
        module.apply(executedAt(3.0, again));
        EXPECT_EQ(module.goalVelocity, counts) << static_cast<int>(manner);
    }
}

/// Seen off, it was not stopped in one of those two.
TEST(ModuleState, AConfirmedMotorOffLeavesTheLoadedVelocity) {
    servo::LoadTrajectory again = velocityMode(0, 100);
    again.velocity.reset();
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(executedAt(2.0, stopWith(servo::StopManner::MotorOff)));
    module.apply(sampleOf(2.1, kMoveDone | kPosError | kPower, 0));
    module.confirmedAtRest();
    module.apply(executedAt(3.0, stopWith(servo::StopManner::Here)));
    module.apply(executedAt(3.1, again));
    EXPECT_EQ(module.goalVelocity, 3);
}

/// A stop's own looks are not always reported, and after it, nobody may be asked any more.
TEST(ModuleState, AMotorThatAStopHasConfirmedAtRestIsNotCountedAsMovingByAnOlderReport) {
    LinkState link;
    link.modules = {holdingServo()};
    ModuleState& module = link.modules.front();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(1.1, kPower, kServoOn, 50));
    EXPECT_EQ(movingModules(link).size(), 1U);
    module.apply(executedAt(2.0, stopWith(servo::StopManner::Abruptly)));
    EXPECT_EQ(movingModules(link).size(), 1U) << "it has not been seen at rest yet";
    module.confirmedAtRest();
    EXPECT_TRUE(movingModules(link).empty());
    EXPECT_TRUE(module.moving()) << "its position is that of a motor in motion";
    module.apply(sampleOf(2.1, kPower, kServoOn, 90));
    EXPECT_EQ(movingModules(link).size(), 1U) << "a later report counts";
}

/// A search for home stops in the same manners.
TEST(ModuleState, ASearchThatEndsWithMotorOffLeavesTheLoadedVelocity) {
    servo::LoadTrajectory again = velocityMode(0, 100);
    again.velocity.reset();
    for (const bool off : {true, false}) {
        ModuleState module = holdingServo();
        module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
        module.apply(
            executedAt(1.1, servo::SetHoming{.onLimit1Change = true, .motorOff = off, .stopAbruptly = !off}));
        module.apply(sampleOf(1.2, kMoveDone | kPower | kHoming, kServoOn));
        module.apply(sampleOf(1.3, kMoveDone | kPower, off ? std::uint8_t{0} : kServoOn));
        module.apply(executedAt(2.0, stopWith(servo::StopManner::Here)));
        module.apply(executedAt(3.0, again));
        EXPECT_EQ(module.goalVelocity, off ? 3 : 0);
    }
}

/// Attached: without a velocity, a run has the one that another host has loaded.
TEST(ModuleState, ARunWhoseVelocityIsUnknownShowsInThePositionOnly) {
    servo::LoadTrajectory run = velocityMode(0, 100);
    run.velocity.reset();
    ModuleState module = servoModule();
    module.attached();
    for (int i = 0; i < 20; ++i)
        module.apply(sampleOf(i * 0.1, kMoveDone | kPower, kServoOn));
    module.apply(executedAt(2.0, run));
    for (int i = 1; i <= 5; ++i)
        module.apply(sampleOf(2.0 + i * 0.1, kMoveDone | kPower, kServoOn, i * 500));
    EXPECT_TRUE(module.moving());
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
}

/// CMC and SC keep the velocity through every stop (docs/family.md).
TEST(ModuleState, NoStopTakesTheLoadedVelocityOfALaterVersionAway) {
    servo::LoadTrajectory again = velocityMode(0, 100);
    again.velocity.reset();
    for (const std::uint8_t version : {kPathVersion, kScVersion}) {
        ModuleState module = holdingServo();
        module.info.identity.version = version;
        module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
        module.apply(executedAt(2.0, stopWith(servo::StopManner::Smoothly)));
        module.confirmedAtRest();
        module.apply(executedAt(3.0, again));
        EXPECT_EQ(module.goalVelocity, 3);
        module.apply(sampleOf(4.0, kPower | kMoveDone, kServoOn, 5'000));
        EXPECT_EQ(module.activity(), Activity::AtSpeed);
    }
}

/// 2 000 000 000 + 1 000 000 000 - 2^32.
TEST(ModuleState, AMoveByADistanceWrapsWithTheCounter) {
    ModuleState module = holdingServo();
    module.info.identity.version = kPathVersion;
    module.apply(executedAt(1.0, servo::StopMotor{true, servo::StopManner::Here, Counts(2'000'000'000)}));
    module.apply(sampleOf(1.1, kPower | kMoveDone, kServoOn, 2'000'000'000));
    ASSERT_EQ(module.goal(), 2'000'000'000);
    servo::LoadTrajectory load = trapezoid(1'000'000'000, 8 << 16, 1'311);
    load.relative = true;
    module.apply(executedAt(1.2, load));
    module.apply(executedAt(1.3, StartMotion{}));
    EXPECT_EQ(module.goal(), -1'294'967'296);
}

/// A servo that holds 20 000, and is 3 counts away from it.
ModuleState heldAt20000() {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, trapezoid(20'000, 8 << 16, 1311)));
    module.apply(executedAt(1.1, StartMotion{}));
    module.apply(sampleOf(9.0, kPower | kMoveDone, kServoOn | kAccelDone | kSlewDone, 19'997));
    return module;
}

/// At rest there is no velocity to remove, so the command position stays where it is (DS-V 5.2, Stop Motor).
TEST(ModuleState, AStopAtRestLeavesWhatIsHeld) {
    for (const auto manner : {servo::StopManner::Smoothly, servo::StopManner::Abruptly}) {
        ModuleState module = heldAt20000();
        EXPECT_TRUE(module.headsFor(20'000));
        module.apply(executedAt(9.5, stopWith(manner)));
        module.apply(sampleOf(9.5, kPower | kMoveDone, kServoOn, 19'998));
        EXPECT_EQ(module.goal(), 20'000);
        EXPECT_FALSE(module.headsFor(20'000)) << "a wait for this move has been stopped";
        module.confirmedAtRest();
        EXPECT_EQ(module.goal(), 20'000);
        // As if Esc were pressed three times.
        module.apply(executedAt(9.6, stopWith(manner)));
        module.apply(executedAt(9.65, stopWith(manner)));
        module.apply(sampleOf(9.7, kPower | kMoveDone, kServoOn, 19'997));
        EXPECT_EQ(module.goal(), 20'000);
    }
}

TEST(ModuleState, AStopThatMayHaveCutAMoveShortLeavesTheGoalUnknown) {
    ModuleState moving = heldAt20000();
    moving.apply(executedAt(9.5, trapezoid(0, 8 << 16, 1311)));
    moving.apply(executedAt(9.6, StartMotion{}));
    // The last status is older than the start, and does not show the motion.
    moving.apply(executedAt(9.601, stopWith(servo::StopManner::Abruptly)));
    moving.apply(sampleOf(9.602, kPower | kMoveDone, kServoOn, 19'997));
    EXPECT_FALSE(moving.goal());

    ModuleState unheard = heldAt20000();
    unheard.confirmedAtRest();  // by a stop whose answer was not received
    EXPECT_FALSE(unheard.goal());

    ModuleState gone = heldAt20000();
    gone.apply(executedAt(9.5, stopWith(servo::StopManner::Smoothly)));
    gone.apply(sampleOf(9.5, kPower | kMoveDone, kServoOn, 19'992));
    EXPECT_FALSE(gone.goal()) << "5 counts away: it may have been off, and switched on where it was";
}

TEST(ModuleState, WhatAStopLeavesDoesNotOutliveTheNextMove) {
    ModuleState module = heldAt20000();
    module.apply(executedAt(9.5, stopWith(servo::StopManner::Smoothly)));
    module.apply(executedAt(9.501, trapezoid(20'002, 8 << 16, 1311)));
    module.apply(executedAt(9.502, StartMotion{}));
    module.apply(sampleOf(9.502, kPower, kServoOn, 19'997));
    EXPECT_EQ(module.goal(), 20'002);
}

TEST(ModuleState, AServoThatGoesOffByItselfIsTripped) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(1.0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::MaybeOff) << "one answer may be wrong";
    EXPECT_FALSE(module.switchedItselfOff);
    module.apply(sampleOf(1.1, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::Tripped);
    EXPECT_EQ(severityOf(module.activity()), Severity::Fault);
}

/// I/O Control of an SC (docs/family.md): a limit switches off if bit 2 is set, and LIMIT1 is the forward
/// one.
TEST(ModuleState, OnlyALimitAheadThatSwitchesOffIsTheCauseOfATrip) {
    using enum servo::LimitStop;
    constexpr std::uint8_t kLimit1 = 0x20;
    constexpr std::uint8_t kLimit2 = 0x40;
    const auto causeOf = [](servo::LimitStop manner, bool reverse, std::uint8_t closed) {
        ModuleState module = holdingServo();
        module.info.identity.version = kScVersion;
        servo::ScIoControl io;
        io.limitStop = manner;
        module.apply(executedAt(1.0, io));
        module.apply(executedAt(1.1, trapezoid(reverse ? -20'000 : 20'000, 8 << 16, 1'311)));
        module.apply(executedAt(1.2, StartMotion{}));
        module.apply(sampleOf(1.3, kPower, kServoOn, reverse ? -100 : 100));
        for (const double seconds : {1.4, 1.5})
            module.apply(sampleOf(seconds, static_cast<std::uint8_t>(kMoveDone | kPosError | kPower | closed),
                                  0, reverse ? -200 : 200));
        EXPECT_TRUE(module.switchedItselfOff);
        return module.tripCause;
    };
    EXPECT_EQ(causeOf(MotorOff, false, kLimit1), TripCause::OffAtLimit1);
    EXPECT_EQ(causeOf(MotorOff, true, kLimit2), TripCause::OffAtLimit2);
    EXPECT_EQ(causeOf(MotorOff, true, kLimit1 | kLimit2), TripCause::OffAtLimit2);
    EXPECT_NE(causeOf(MotorOff, true, kLimit1), TripCause::OffAtLimit1) << "it moved away from it";
    EXPECT_NE(causeOf(Abruptly, true, kLimit1), TripCause::OffAtLimit1);
    EXPECT_NE(causeOf(Abruptly, false, kLimit1), TripCause::OffAtLimit1) << "it would have stopped, and held";
}

/// The answer may be old, damaged, or that of another module.
TEST(ModuleState, OneAnswerThatItIsOffIsADoubtThatTheNextEnds) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(0.5, kMoveDone | kPower, kServoOn));
    module.apply(sampleOf(1.0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::MaybeOff);
    module.apply(sampleOf(1.1, kMoveDone | kPower, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Holding);
    EXPECT_FALSE(module.switchedItselfOff);
    module.apply(sampleOf(1.2, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::MaybeOff) << "the doubt begins again";
}

TEST(ModuleState, PowerLossIsToldFromATripAndStaysWhenPowerIsBack) {
    ModuleState module = holdingServo();
    module.apply(sampleOf(1.0, kMoveDone | kPosError, 0));
    module.apply(sampleOf(1.1, kMoveDone | kPosError, 0));
    EXPECT_EQ(module.activity(), Activity::PowerLost);
    module.apply(sampleOf(2.0, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::PowerLost);
}

TEST(ModuleState, SwitchingItOffIsNotATrip) {
    for (const bool sampleFirst : {false, true}) {
        ModuleState module = holdingServo();
        const auto off = executedAt(1.0, stopWith(servo::StopManner::MotorOff, false));
        const auto seen = sampleOf(1.0, kMoveDone | kPosError | kPower, 0);
        if (sampleFirst) {
            module.apply(seen);
            module.apply(off);
        } else {
            module.apply(off);
            module.apply(seen);
        }
        EXPECT_EQ(module.activity(), Activity::ServoOff);
        EXPECT_EQ(module.amplifierEnabled, false);
    }
}

/// DS-V 5.2: home is found while the servo is off, and an abrupt stop switches it on, so what switches it off
/// after that is no command.
TEST(ModuleState, ATripIsOneAlsoWhereAStopAtHomeHasSwitchedTheServoOn) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, stopWith(servo::StopManner::MotorOff)));
    module.apply(sampleOf(1.0, kMoveDone | kPosError | kPower, 0));
    module.apply(executedAt(1.1, servo::SetHoming{.onLimit1Change = true, .stopAbruptly = true}));
    module.apply(sampleOf(1.2, kMoveDone | kPosError | kPower | kHoming, 0));
    module.apply(sampleOf(1.3, kMoveDone | kPosError | kPower, kServoOn));
    module.apply(sampleOf(1.4, kMoveDone | kPosError | kPower, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Holding);
    module.apply(sampleOf(1.5, kMoveDone | kPosError | kPower, 0));
    module.apply(sampleOf(1.6, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::Tripped);
    EXPECT_TRUE(module.switchedItselfOff);
}

TEST(ModuleState, KeepsWhatAShorterStatusDoesNotCarry) {
    ModuleState module = servoModule();
    StatusReport full;
    full.items = StatusItems(StatusItems::All);
    full.position = 5;
    full.home = 77;
    full.analog = std::uint8_t{12};
    full.aux = std::uint8_t{0};
    module.apply(bus::Sample{ModuleIndex(0), atSeconds(1), full});
    module.apply(sampleOf(2, kPower, 0, 6));
    EXPECT_EQ(module.latest->position, 6);
    EXPECT_EQ(module.latest->home, 77);
    EXPECT_EQ(module.latest->analog, 12);
}

TEST(ModuleState, GainsAreUnknownUntilTheyWereConfirmed) {
    EXPECT_FALSE(servoModule().gains.has_value());
    EXPECT_EQ(holdingServo().gains->kd, 2'000);
}

TEST(ModuleState, APwmValueOnAServoThatIsOffIsMotion) {
    ModuleState module = holdingServo();
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{40};
    pwm.startNow = true;
    module.apply(executedAt(1, pwm));
    module.apply(sampleOf(1, kMoveDone | kPosError | kPower, 0));
    EXPECT_EQ(module.activity(), Activity::PwmMode);
    EXPECT_TRUE(module.moving());
}

/// DS-V 4.5 sets the value to 0 only when it disables the servo, which is off already.
TEST(ModuleState, APwmValueIsMotionWithoutPowerToo) {
    ModuleState module = holdingServo();
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{40};
    pwm.startNow = true;
    module.apply(executedAt(1, pwm));
    for (int look = 0; look < 6; ++look) {
        const std::uint8_t power = look < 2 || look > 3 ? kPower : std::uint8_t{0};
        module.apply(sampleOf(1 + look * 0.1, static_cast<std::uint8_t>(kMoveDone | kPosError | power), 0));
        EXPECT_EQ(module.activity(), Activity::PwmMode) << look;
        EXPECT_TRUE(module.moving()) << look;
    }
    module.apply(executedAt(2, stopWith(servo::StopManner::MotorOff)));
    module.apply(sampleOf(2.1, kMoveDone | kPosError, 0));
    EXPECT_EQ(module.activity(), Activity::NoPower);
    EXPECT_FALSE(module.moving());
}

/// AMP_EN stays high through a trip, so the page PWM sends no stop first.
TEST(ModuleState, APwmValueAfterATripIsMotion) {
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{40};
    for (const std::uint8_t power : {kPower, std::uint8_t{0}}) {
        ModuleState module = holdingServo();
        for (const double seconds : {1.0, 1.1})
            module.apply(sampleOf(seconds, static_cast<std::uint8_t>(kMoveDone | kPosError | power), 0));
        EXPECT_EQ(module.activity(), power != 0 ? Activity::Tripped : Activity::PowerLost);
        module.apply(sampleOf(1.2, kMoveDone | kPosError | kPower, 0));
        module.apply(executedAt(2.0, pwm));
        EXPECT_TRUE(module.switchedItselfOff) << "loaded only";
        module.apply(executedAt(2.1, StartMotion{}));
        module.apply(sampleOf(2.2, kMoveDone | kPosError | kPower, 0, 20));
        EXPECT_EQ(module.activity(), Activity::PwmMode);
        EXPECT_FALSE(module.switchedItselfOff);
    }
}

TEST(ModuleState, SilenceComesBeforeEverythingElse) {
    ModuleState module = holdingServo();
    module.silent = true;
    EXPECT_EQ(module.activity(), Activity::Unresponsive);
}

/// Attached: the velocity item has no fraction, so a slow motion shows in the position only.
TEST(ModuleState, AServoThatAnotherHostLeftMovingIsMoving) {
    ModuleState module = servoModule();
    module.attached();
    for (int i = 0; i <= 20; ++i)
        module.apply(sampleOf(i * 0.1, kMoveDone | kPower, kServoOn, i * 10));
    EXPECT_TRUE(module.moving());
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    for (int i = 0; i <= 20; ++i)
        module.apply(sampleOf(2.1 + i * 0.1, kMoveDone | kPower, kServoOn, 200 + i % 2));
    EXPECT_FALSE(module.moving()) << "it moves only within its friction";
    EXPECT_EQ(module.activity(), Activity::Holding);
}

/// Attached: the status of a PIC-STEP says whether it moves, and a PIC-I/O has no motor.
TEST(ModuleState, OnlyTheMotionOfAServoThatIsOnShowsInItsSecondReport) {
    for (const ModuleIdentity identity :
         {ModuleIdentity{ModuleType::Servo, 4}, ModuleIdentity{ModuleType::Stepper, 1},
          ModuleIdentity{ModuleType::Io, 1}}) {
        ModuleState module;
        module.info = {ModuleIndex(0), BusAddress(1), identity};
        module.attached();
        EXPECT_FALSE(module.motionSeen());
        module.apply(sampleOf(0.1, kPower, kServoOn));
        EXPECT_EQ(module.motionSeen(), !module.isServo()) << static_cast<int>(identity.type);
        module.apply(sampleOf(0.2, kPower, kServoOn));
        EXPECT_TRUE(module.motionSeen()) << static_cast<int>(identity.type);
    }
}

/// DS-V 4.5: SR is 1 after power-up and reset. It is set with the gains, and cannot be read back.
TEST(ModuleState, TheServoRateIsKnownFromPowerUpUntilAnotherHostMayHaveSetIt) {
    ModuleState module = servoModule();
    EXPECT_EQ(module.servoRate, 1);
    module.attached();
    EXPECT_FALSE(module.servoRate);
    servo::SetGain gains;
    gains.sr = 5;
    module.apply(executedAt(1.0, gains));
    EXPECT_EQ(module.servoRate, 5);
    module.doubtGains();
    EXPECT_FALSE(module.servoRate);
    EXPECT_FALSE(module.gains);
    module.restarted();
    EXPECT_EQ(module.servoRate, 1);
}

/// Set Timer Mode clears the count (docs/family.md), and so does a restart.
TEST(ModuleState, ACounterThatWasClearedHasNoRateUntilItHasCounted) {
    ModuleState module;
    module.info = {ModuleIndex(0), BusAddress(1), {ModuleType::Io, 1}};
    double time = 1.0;
    const auto counts = [&](std::uint32_t first) {  // at 1 000 counts/s
        for (std::uint32_t i = 0; i <= 20; ++i) {
            bus::Sample sample{ModuleIndex(0), atSeconds(time += 0.01), {}};
            sample.report.counter = first + 10 * i;
            module.apply(sample);
            EXPECT_NEAR(module.counting.perSecond().value_or(1'000), 1'000, 0.01) << i;
        }
        EXPECT_TRUE(module.counting.perSecond());
    };
    counts(50'000);
    module.apply(bus::CommandExecuted{ModuleIndex(0), atSeconds(time), IoCommand(io::SetTimerMode{})});
    counts(10);
    module.restarted();
    counts(0);
}

// ---- doubtful answers, and commands without one ----

/// Answers of a neighbouring module: only the position reveals them, and it stays in doubt until there has
/// been no jump for a while.
TEST(ModuleState, AJumpThatNoMotionLeadsToIsDoubtfulForAWhile) {
    ModuleState module = holdingServo();
    const auto says = [&module](double seconds, std::int32_t position, bool jumped = false) {
        bus::Sample sample = sampleOf(seconds, kMoveDone | kPower, kServoOn, position);
        sample.jumped = jumped;
        module.apply(sample);
    };
    says(1.0, 0);
    EXPECT_FALSE(module.positionDoubtful());
    says(1.1, 3'386, true);
    EXPECT_TRUE(module.positionDoubtful());
    EXPECT_EQ(module.speed.perSecond().value_or(0), 0) << "that is no motion";
    says(3.0, 3'386);
    EXPECT_TRUE(module.positionDoubtful());
    says(3.05, 0, true);  // its own answers again
    says(5.0, 0);
    EXPECT_TRUE(module.positionDoubtful());
    says(5.1, 0);
    EXPECT_FALSE(module.positionDoubtful());
    LinkState link;
    link.phase = LinkPhase::Connected;
    EXPECT_TRUE(isLive(link, module));
    says(6.0, 3'386, true);
    EXPECT_FALSE(isLive(link, module)) << "shown as not current";
}

/// After a start that was not answered, it may be moving; it is at speed only if its position shows that.
TEST(ModuleState, AServoThatStandsBehindADoubtIsNotAtSpeed) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(1.9, kPower | kMoveDone, kServoOn, 4'500));
    module.apply(sampleOf(2.0, kPower | kMoveDone, kServoOn, 5'000));
    module.doubtMotion();
    module.apply(sampleOf(2.1, kPower | kMoveDone, kServoOn, 5'500));
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    module.apply(sampleOf(2.2, kPower | kMoveDone, kServoOn, 5'600));
    module.apply(sampleOf(2.5, kPower | kMoveDone, kServoOn, 5'600));
    EXPECT_EQ(module.activity(), Activity::MaybeMoving);
    EXPECT_TRUE(module.moving()) << "no motion may be started in this state";
    module.apply(sampleOf(3.3, kPower | kMoveDone, kServoOn, 5'600));
    EXPECT_EQ(module.activity(), Activity::Holding);
}

TEST(ModuleState, AVelocityThatWasStoppedUnheardIsNotBelievedAnyMore) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(2.0, kPower | kMoveDone, kServoOn, 5'000));
    ASSERT_EQ(module.activity(), Activity::AtSpeed);
    module.doubtMotion();  // silent; it was sent a stop, and is at rest when it answers again
    module.apply(sampleOf(4.0, kPower | kMoveDone, kServoOn, 9'000));
    EXPECT_TRUE(module.moving()) << "still unknown";
    for (int i = 1; i <= 15; ++i)
        module.apply(sampleOf(4.0 + i * 0.1, kPower | kMoveDone, kServoOn, 9'000 + i % 2));
    EXPECT_EQ(module.activity(), Activity::Holding);
    EXPECT_FALSE(module.moving());
}

TEST(ModuleState, AVelocityThatGoesOnUnheardIsMotion) {
    ModuleState module = holdingServo();
    module.doubtMotion();  // a start was not answered
    for (int i = 0; i <= 5; ++i)
        module.apply(sampleOf(1.0 + i * 0.1, kPower | kMoveDone, kServoOn, i * 20));
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    EXPECT_TRUE(module.moving());
}

/// A program at the lent line may ask for the position only.
TEST(ModuleState, AVelocityThatGoesOnUnheardShowsInThePositionAlone) {
    ModuleState module = holdingServo();
    module.doubtMotion();  // nobody answers a group command
    for (int i = 0; i <= 5; ++i) {
        bus::Sample sample = sampleOf(1.0 + i * 0.1, kPower | kMoveDone, 0, i * 20);
        sample.report.aux.reset();
        module.apply(sample);
    }
    EXPECT_EQ(module.activity(), Activity::AtSpeed);
    EXPECT_TRUE(module.moving());
}

TEST(ModuleState, AConfirmedStopIsBelievedAtOnce) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, velocityMode(3 << 16, 100)));
    module.apply(sampleOf(2.0, kPower | kMoveDone, kServoOn, 5'000));
    module.doubtMotion();
    module.confirmedAtRest();
    EXPECT_EQ(module.activity(), Activity::Holding);
    EXPECT_FALSE(module.moving());
}

TEST(ModuleState, AShaftThatTurnsAlthoughTheMotorIsOffSaysSo) {
    ModuleState module = holdingServo();
    module.apply(executedAt(1.0, stopWith(servo::StopManner::MotorOff, false)));
    module.apply(sampleOf(1.1, kMoveDone | kPosError | kPower, 0, 0));
    EXPECT_EQ(module.activity(), Activity::ServoOff);
    for (int i = 1; i <= 5; ++i)
        module.apply(sampleOf(1.1 + i * 0.1, kMoveDone | kPosError | kPower, 0, i * -30));
    EXPECT_EQ(module.activity(), Activity::Turned);
    EXPECT_EQ(severityOf(module.activity()), Severity::Attention);
    EXPECT_FALSE(module.moving()) << "no stop could hold it";
    for (int i = 1; i <= 12; ++i)
        module.apply(sampleOf(1.6 + i * 0.1, kMoveDone | kPosError | kPower, 0, -150 + i % 2));
    EXPECT_EQ(module.activity(), Activity::ServoOff);
}

TEST(ModuleState, AServoThatLimitsItsCurrentIsNotSimplyHolding) {
    constexpr std::uint8_t kOvercurrent = 0x04;  // DS-V 4.5: stays until it is cleared
    ModuleState module = holdingServo();
    module.apply(sampleOf(1.0, kMoveDone | kPower | kOvercurrent, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Limited);
    EXPECT_EQ(severityOf(module.activity()), Severity::Attention);
    EXPECT_TRUE(module.currentWasLimited());
    module.apply(sampleOf(2.0, kMoveDone | kPower, kServoOn));
    EXPECT_EQ(module.activity(), Activity::Holding);
}

TEST(ModuleState, AModuleThatRestartedIsOffAndHasForgotten) {
    ModuleState module = holdingServo();
    module.restarted();
    EXPECT_FALSE(module.servoOn());
    EXPECT_FALSE(module.driveOn());
    EXPECT_EQ(module.activity(), Activity::Restarted);
    EXPECT_FALSE(module.gains.has_value());
    EXPECT_FALSE(module.moving());
}

}  // namespace
}  // namespace nmc
