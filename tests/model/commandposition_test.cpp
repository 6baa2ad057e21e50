// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/commandposition.h"

#include <gtest/gtest.h>

#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr double kTick = 0.000512;

/// Switched on at t = 0 at 100 counts.
CommandPosition holdingAt100() {
    CommandPosition command;
    command.apply(sampleOf(-1, kMoveDone | kPosError | kPower, 0, 90));
    command.apply(executedAt(0, stopWith(servo::StopManner::Abruptly)));
    command.apply(sampleOf(0, kMoveDone | kPosError | kPower, kServoOn, 100));
    return command;
}

TEST(CommandPosition, IsUnknownWhileTheServoIsOff) {
    CommandPosition command;
    EXPECT_FALSE(command.at(atSeconds(0)).has_value());
    command.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0, 90));
    EXPECT_FALSE(command.at(atSeconds(0)).has_value());
}

TEST(CommandPosition, HoldsWhereTheServoWasSwitchedOn) {
    EXPECT_EQ(holdingAt100().at(atSeconds(5)), 100.0);
}

TEST(CommandPosition, IsNotGuessedFromASampleOfARunningServo) {
    CommandPosition command;  // attached: the servo was on before we came
    command.apply(sampleOf(0, kMoveDone | kPower, kServoOn, 100));
    EXPECT_FALSE(command.at(atSeconds(0)).has_value());
}

TEST(CommandPosition, FollowsATrapezoidalMoveInCountsPerTick) {
    CommandPosition command = holdingAt100();
    // 8 counts/tick, 1/64 count/tick^2 = 1024: ramps of 512 ticks and 2048 counts; slew 15 904 counts in 1988
    // ticks.
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    EXPECT_EQ(command.at(atSeconds(2)), 100.0) << "loaded only";
    command.apply(executedAt(2, StartMotion{}));
    EXPECT_NEAR(*command.at(atSeconds(2 + 512 * kTick)), 100 + 2'048, 1e-6);
    EXPECT_NEAR(*command.at(atSeconds(2 + 1'512 * kTick)), 100 + 2'048 + 8'000, 1e-6);
    EXPECT_NEAR(*command.at(atSeconds(2 + 3'011 * kTick)), 20'100, 0.02);
    EXPECT_EQ(*command.at(atSeconds(2 + 3'012 * kTick)), 20'100);
}

TEST(CommandPosition, AVelocityChangedOnTheFlyStaysContinuous) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 4 << 16)));  // reaches 4 counts/tick within a tick
    const double before = *command.at(atSeconds(1));
    EXPECT_NEAR(before, 100 + 4 * (1 / kTick) - 2, 1e-6);
    command.apply(executedAt(1, velocityMode(4 << 16, 1'024, true)));
    EXPECT_EQ(*command.at(atSeconds(1)), before);
    // From +4 to -4 at 1/64 takes 512 ticks; half-way it turns around.
    EXPECT_NEAR(*command.at(atSeconds(1 + 512 * kTick)), before, 1e-6);
}

TEST(CommandPosition, AnAbruptStopFreezesItAndASmoothStopRampsDown) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    const double at1 = *command.at(atSeconds(1));
    CommandPosition abrupt = command;
    abrupt.apply(executedAt(1, stopWith(servo::StopManner::Abruptly)));
    EXPECT_EQ(*abrupt.at(atSeconds(9)), at1);
    command.apply(executedAt(1, stopWith(servo::StopManner::Smoothly)));
    EXPECT_NEAR(*command.at(atSeconds(9)), at1 + 4.0 * 4.0 * 64 / 2, 1e-6);  // v^2 / 2a
}

TEST(CommandPosition, AStopTakesTheVelocityAway) {
    // protocol.md 2: on v1-v4 Stop zeroes the velocity parameter; a start without a new load goes nowhere.
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    command.apply(executedAt(1, stopWith(servo::StopManner::Abruptly)));
    const double held = *command.at(atSeconds(1));
    command.apply(executedAt(2, StartMotion{}));
    EXPECT_EQ(*command.at(atSeconds(9)), held);
}

TEST(CommandPosition, StopHereJumps) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, servo::StopMotor{true, servo::StopManner::Here, Counts(130)}));
    EXPECT_EQ(*command.at(atSeconds(1)), 130.0);
}

TEST(CommandPosition, ZeroHereMovesTheOrigin) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, ResetPosition{}));
    EXPECT_EQ(*command.at(atSeconds(2)), 0.0);
}

TEST(CommandPosition, EndsWithMotorOffAndWithATrip) {
    CommandPosition off = holdingAt100();
    off.apply(executedAt(1, stopWith(servo::StopManner::MotorOff, false)));
    EXPECT_FALSE(off.at(atSeconds(1)).has_value());
    CommandPosition tripped = holdingAt100();
    tripped.apply(sampleOf(1, kMoveDone | kPosError | kPower, 0, 100));
    EXPECT_FALSE(tripped.at(atSeconds(1)).has_value());
}

TEST(CommandPosition, ADoubtEndsAtTheGoalOfTheNextMove) {
    CommandPosition command = holdingAt100();
    command.forget();
    EXPECT_FALSE(command.at(atSeconds(1)).has_value());
    command.apply(executedAt(1, trapezoid(500, 8 << 16, 1'024)));
    command.apply(executedAt(1, StartMotion{}));
    command.apply(sampleOf(1, kPower, kServoOn, 101));
    EXPECT_FALSE(command.at(atSeconds(1.1)).has_value());
    command.apply(sampleOf(2, kPower | kMoveDone, kServoOn, 499));
    EXPECT_EQ(*command.at(atSeconds(3)), 500.0);
}

TEST(CommandPosition, ALongerServoTickSlowsTheSameProfile) {
    CommandPosition command = holdingAt100();
    servo::SetGain gains;
    gains.sr = 3;
    command.apply(executedAt(0, gains));
    command.apply(executedAt(1, velocityMode(4 << 16, 4 << 16)));
    const double a = *command.at(atSeconds(2));
    const double b = *command.at(atSeconds(3));
    EXPECT_NEAR(b - a, 4 / (3 * kTick), 1e-6);
    gains.sr = 1;
    command.apply(executedAt(3, gains));
    constexpr double kNanosecondOfTravel = 4 / kTick * 1e-9;  // start times are whole nanoseconds
    EXPECT_NEAR(*command.at(atSeconds(3)), b, kNanosecondOfTravel);
    EXPECT_NEAR(*command.at(atSeconds(4)) - b, 4 / kTick, kNanosecondOfTravel);
}

TEST(CommandPosition, AHomingStopAtAnUnknownMomentMakesItUnknown) {
    CommandPosition command = holdingAt100();
    servo::SetHoming homing;
    homing.onLimit1Change = homing.stopAbruptly = true;
    command.apply(executedAt(0.5, homing));
    command.apply(executedAt(1, velocityMode(4 << 16, 1'024)));
    command.apply(sampleOf(1.5, kPower | kHoming, kServoOn, 900));
    EXPECT_TRUE(command.at(atSeconds(1.5)).has_value());
    command.apply(sampleOf(2, kPower | kMoveDone, kServoOn, 1'500));
    EXPECT_FALSE(command.at(atSeconds(2)).has_value());
}

}  // namespace
}  // namespace nmc
