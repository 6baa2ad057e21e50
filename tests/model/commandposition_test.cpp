// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/commandposition.h"

#include <gtest/gtest.h>

#include "servofixture.h"
#include "tests/support/servotick.h"

namespace nmc {
namespace {

using namespace testing_support;

CommandEstimate exactly(double position) {
    return {position, position, position};
}

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
    EXPECT_EQ(holdingAt100().at(atSeconds(5)), exactly(100));
}

TEST(CommandPosition, IsNotGuessedFromASampleOfARunningServo) {
    CommandPosition command;  // attached: the servo was already on
    command.apply(sampleOf(0, kMoveDone | kPower, kServoOn, 100));
    EXPECT_FALSE(command.at(atSeconds(0)).has_value());
}

TEST(CommandPosition, FollowsATrapezoidalMoveInStepsOfATick) {
    CommandPosition command = holdingAt100();
    // 8 counts/tick, 1/64 count/tick^2 = 1024: 512 ticks to full speed, which cover 512 x 513 / 2 / 64 = 2052
    // counts; after 15 900 counts at full speed, slowing down takes another 2048.
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    EXPECT_EQ(command.at(atSeconds(2)), exactly(100)) << "it is only loaded";
    command.apply(executedAt(2, StartMotion{}));
    EXPECT_NEAR(command.at(atSeconds(2 + 512 * kTick))->position, 100 + 2'052, 0.01);
    EXPECT_NEAR(command.at(atSeconds(2 + 1'512 * kTick))->position, 100 + 2'052 + 8'000, 0.01);
    EXPECT_NEAR(command.at(atSeconds(2 + 3'010 * kTick))->position, 20'100, 0.1);
    EXPECT_EQ(command.at(atSeconds(2 + 3'020 * kTick)), exactly(20'100));
}

TEST(CommandPosition, KnowsTheMomentOfACommandAndOfAStatusToHalfATickEach) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    command.apply(executedAt(2, StartMotion{}));
    // Both times may be off by half a tick, and a reply that is another half tick late still counts as
    // prompt: 1.5 ticks of 8 counts. The steps deviate from the curve by 1/64/8 of a count, and the clocks by
    // 0.01 % of 1000 ticks.
    const CommandEstimate full = *command.at(atSeconds(2 + 1'000 * kTick));
    EXPECT_NEAR(full.high - full.position, 12 + 0.8, 0.1);
    EXPECT_NEAR(full.position - full.low, 12 + 0.8, 0.1);
}

TEST(CommandPosition, IsUncertainToOneSideWhenAReplyIsLate) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    command.apply(executedAt(2, StartMotion{}));
    const TimePoint then = atSeconds(2 + 1'000 * kTick);
    const CommandEstimate prompt = *command.at(then);
    const CommandEstimate late = *command.at(then, 10 * kServoTick);
    EXPECT_EQ(late.position, prompt.position);
    EXPECT_EQ(late.low, prompt.low);
    EXPECT_NEAR(late.high, prompt.high + 80, 0.02);
}

/// The delay of a reply that was sent no later than a quarter of a tick after its calculated time.
constexpr Duration kAtOnce = -3 * kServoTick / 4;

// The command and the status are 100 ticks apart; both were latched at the calculated time or up to a quarter
// of a tick before it.
TEST(CommandPosition, CountsTheTicksBetweenACommandAndAStatus) {
    CommandPosition command = holdingAt100();
    bus::CommandExecuted run = executedAt(1, velocityMode(4 << 16, 4 << 16));
    run.late = kAtOnce;
    command.apply(run);
    // The velocity is reached with the first step; the steps deviate from the curve by an eighth of the
    // acceleration.
    const CommandEstimate then = *command.at(atSeconds(1 + 100 * kTick), kAtOnce);
    EXPECT_EQ(then.position, 100 + 4 * 100);
    EXPECT_EQ(then.high, 100 + 4 * 100);
    EXPECT_GE(then.low, 100 + 4 * 100 - 4.0 / 8);
}

TEST(CommandPosition, IsKnownLessWellWhereTheTicksAreNotWhereTheyWereCounted) {
    CommandPosition command = holdingAt100();
    bus::CommandExecuted run = executedAt(1, velocityMode(4 << 16, 4 << 16));
    run.late = kAtOnce;
    command.apply(run);
    // The tick of the command was between 0.5 before the calculated time and 0.25 after it. There can be no
    // tick between 100.3 and 100.4 ticks after that.
    bus::Sample sample = sampleOf(1 + 100.8 * kTick, kMoveDone | kPower, kServoOn, 400);
    sample.late = -7 * kServoTick / 5;
    command.apply(sample);
    const auto known = command.at(sample.time, sample.late);
    ASSERT_TRUE(known);
    // The band extends from the counted to the observed position, plus a tick by which the clocks may have
    // drifted apart.
    EXPECT_LT(known->low, 100 + 4 * (100.3 - 0.25) - 2);
    EXPECT_GT(known->high, 100 + 4 * (100.4 + 0.5) + 2);
    EXPECT_LT(known->high - known->low, 4 * 4);
}

TEST(CommandPosition, AVelocityChangedOnTheFlyStaysContinuous) {
    CommandPosition command = holdingAt100();
    command.apply(
        executedAt(0, velocityMode(4 << 16, 4 << 16)));  // reaches 4 counts/tick with its first step
    const CommandEstimate before = *command.at(atSeconds(1));
    EXPECT_NEAR(before.position, 100 + 4 * (1 / kTick), 1e-6);
    command.apply(executedAt(1, velocityMode(4 << 16, 1'024, true)));
    EXPECT_NEAR(command.at(atSeconds(1))->position, before.position, 0.01);
    // From +4 to -4 at 1/64 takes 512 ticks, and it turns around half-way: the first step is already below
    // +4, and the last one is at -4.
    EXPECT_NEAR(command.at(atSeconds(1 + 512 * kTick))->position, before.position - 4, 0.01);
}

TEST(CommandPosition, OnlyTheChangeOfAVelocityLeavesADoubt) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 4 << 16)));
    const CommandEstimate before = *command.at(atSeconds(0.1));
    command.apply(executedAt(0.1, velocityMode(4 << 16, 4 << 16)));  // the same command again changes nothing
    const CommandEstimate after = *command.at(atSeconds(0.1));
    EXPECT_NEAR(after.low, before.low, 0.01);
    EXPECT_NEAR(after.high, before.high, 0.01);
}

/// A tick may be 0.5 ms or 131 ms long: how far the motion has come is unknown, only its goal is known.
TEST(CommandPosition, FollowsNoMotionWhileTheServoRateIsUnknown) {
    CommandPosition command = holdingAt100();
    command.doubtServoRate();
    EXPECT_EQ(command.at(atSeconds(0.5)), exactly(100)) << "the held position does not depend on the tick";
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    command.apply(executedAt(2, StartMotion{}));
    EXPECT_FALSE(command.at(atSeconds(2.2)).has_value());
    command.apply(sampleOf(60, kMoveDone | kPower, kServoOn, 20'100));
    EXPECT_EQ(command.at(atSeconds(60)), exactly(20'100));
    command.apply(executedAt(61, velocityMode(8 << 16, 1'024)));
    EXPECT_FALSE(command.at(atSeconds(61.5)).has_value());
    command.apply(executedAt(62, stopWith(servo::StopManner::Here)));
    servo::SetGain gains;
    gains.sr = 2;
    gains.el = 4'000;
    command.apply(executedAt(63, gains));
    command.apply(executedAt(64, velocityMode(8 << 16, 1'024)));
    EXPECT_TRUE(command.at(atSeconds(64.5)).has_value()) << "known from now on";
}

TEST(CommandPosition, FollowsNoMotionAtAVelocityThatAnotherHostHasLoaded) {
    CommandPosition command;
    command.attached();
    servo::SetGain gains;
    gains.sr = 1;
    command.apply(executedAt(0, gains));
    command.apply(executedAt(1, stopWith(servo::StopManner::Here)));
    EXPECT_EQ(command.at(atSeconds(1.5)), exactly(0));
    servo::LoadTrajectory run = velocityMode(8 << 16, 1'024);
    run.velocity.reset();
    command.apply(executedAt(2, run));
    EXPECT_FALSE(command.at(atSeconds(2.5)).has_value());
    command.apply(executedAt(3, stopWith(servo::StopManner::Here)));
    servo::LoadTrajectory move = trapezoid(20'000, 8 << 16, 1'024);
    move.velocity.reset();
    command.apply(executedAt(4, move));
    command.apply(executedAt(5, StartMotion{}));
    EXPECT_FALSE(command.at(atSeconds(6)).has_value());
    command.apply(sampleOf(60, kMoveDone | kPower, kServoOn, 20'000));
    EXPECT_EQ(command.at(atSeconds(60)), exactly(20'000)) << "the goal is known";
}

TEST(CommandPosition, AnAbruptStopFreezesItAndASmoothStopRampsDown) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    const CommandEstimate at1 = *command.at(atSeconds(1));
    CommandPosition abrupt = command;
    abrupt.apply(executedAt(1, stopWith(servo::StopManner::Abruptly)));
    EXPECT_EQ(*abrupt.at(atSeconds(9)), at1);
    command.apply(executedAt(1, stopWith(servo::StopManner::Smoothly)));
    // 255 steps, from 255/64 down to 1/64.
    EXPECT_NEAR(command.at(atSeconds(9))->position, at1.position + 255 * 256 / 2 / 64.0, 0.01);
}

TEST(CommandPosition, AStopTakesTheVelocityAway) {
    // protocol.md 2: on v1-v4 Stop zeroes the velocity parameter; a start without a new load goes nowhere.
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    command.apply(executedAt(1, stopWith(servo::StopManner::Abruptly)));
    const double held = command.at(atSeconds(1))->position;
    command.apply(executedAt(2, StartMotion{}));
    EXPECT_EQ(command.at(atSeconds(9))->position, held);
}

/// DS-V 5.2, Stop Motor: of the manners, only "abruptly" and "smoothly" set the goal velocity to zero.
TEST(CommandPosition, StopHereLeavesTheVelocity) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    command.apply(executedAt(1, servo::StopMotor{true, servo::StopManner::Here, Counts(130)}));
    servo::LoadTrajectory again = velocityMode(0, 1'024);
    again.velocity.reset();
    command.apply(executedAt(2, again));
    // 256 ticks to 4 counts/tick at 1/64, which cover 256 x 257 / 2 / 64 = 514 counts.
    EXPECT_NEAR(command.at(atSeconds(2 + 256 * kTick))->position, 130 + 514, 4);
}

TEST(CommandPosition, StopHereJumps) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, servo::StopMotor{true, servo::StopManner::Here, Counts(130)}));
    EXPECT_EQ(command.at(atSeconds(1)), exactly(130));
}

TEST(CommandPosition, ZeroHereMovesTheOrigin) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, ResetPosition{}));
    EXPECT_EQ(command.at(atSeconds(2)), exactly(0));
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
    EXPECT_EQ(command.at(atSeconds(3)), exactly(500));
}

TEST(CommandPosition, ALongerServoTickSlowsTheSameProfile) {
    CommandPosition command = holdingAt100();
    servo::SetGain gains;
    gains.sr = 3;
    command.apply(executedAt(0, gains));
    command.apply(executedAt(1, velocityMode(4 << 16, 4 << 16)));
    const double a = command.at(atSeconds(2))->position;
    const double b = command.at(atSeconds(3))->position;
    EXPECT_NEAR(b - a, 4 / (3 * kTick), 1e-6);
    gains.sr = 1;
    command.apply(executedAt(3, gains));
    constexpr double kNanosecondOfTravel = 4 / kTick * 1e-9;  // start times are whole nanoseconds
    EXPECT_NEAR(command.at(atSeconds(3))->position, b, kNanosecondOfTravel);
    EXPECT_NEAR(command.at(atSeconds(4))->position - b, 4 / kTick, kNanosecondOfTravel);
}

CommandPosition searchingHome(servo::SetHoming homing) {
    CommandPosition command = holdingAt100();
    homing.onLimit1Change = true;
    command.apply(executedAt(0.5, homing));
    command.apply(executedAt(1, velocityMode(4 << 16, 4 << 16)));
    command.apply(sampleOf(1.5, kPower | kHoming | kMoveDone, kServoOn, 900));
    return command;
}

TEST(CommandPosition, AnAbruptStopAtHomeWasSomewhereBetweenTwoSamples) {
    servo::SetHoming homing;
    homing.stopAbruptly = true;
    CommandPosition command = searchingHome(homing);
    const CommandEstimate before = *command.at(atSeconds(1.5));
    const CommandEstimate unstopped = *command.at(atSeconds(1.6));
    command.apply(sampleOf(1.6, kPower | kMoveDone, kServoOn, 4'500));
    const CommandEstimate stopped = *command.at(atSeconds(1.6));
    EXPECT_EQ(stopped.low, before.low);
    EXPECT_EQ(stopped.high, unstopped.high);
    EXPECT_NEAR(stopped.position, (before.position + unstopped.position) / 2, 0.01);
    EXPECT_EQ(*command.at(atSeconds(9)), stopped);
}

TEST(CommandPosition, ASmoothStopAtHomeRampsDownFromThere) {
    servo::SetHoming homing;
    homing.stopSmoothly = true;
    CommandPosition command = searchingHome(homing);
    const CommandEstimate before = *command.at(atSeconds(1.5));
    const CommandEstimate unstopped = *command.at(atSeconds(1.6));
    command.apply(sampleOf(1.6, kPower | kMoveDone, kServoOn, 4'500));
    const CommandEstimate stopped = *command.at(atSeconds(1.7));
    EXPECT_NEAR(stopped.position, (before.position + unstopped.position) / 2, 0.01);
    EXPECT_NEAR(stopped.low, before.low, 4);  // its ramp is one tick long
    EXPECT_NEAR(stopped.high, unstopped.high, 4);
}

TEST(CommandPosition, HomeSwitchesTheServoOffAndNothingIsLeft) {
    servo::SetHoming homing;
    homing.motorOff = true;
    CommandPosition command = searchingHome(homing);
    command.apply(sampleOf(1.6, kPower | kMoveDone | kPosError, 0, 4'500));
    EXPECT_FALSE(command.at(atSeconds(1.6)).has_value());
}

/// Without a condition, Set Homing Mode cancels the search (protocol.md 2).
TEST(CommandPosition, ASearchThatIsCancelledStopsNothing) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, velocityMode(4 << 16, 4 << 16)));
    servo::SetHoming cancel;
    cancel.stopAbruptly = true;
    command.apply(executedAt(1.2, cancel));
    command.apply(sampleOf(1.5, kPower | kMoveDone, kServoOn, 4'000));
    EXPECT_NEAR(command.at(atSeconds(2.5))->position - command.at(atSeconds(1.5))->position, 4 / kTick, 4);
}

TEST(CommandPosition, AMoveThatIsDoneIsAtItsGoalWhateverTheClockSays) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    command.apply(executedAt(2, StartMotion{}));  // takes 3011 ticks = 1.54 s
    command.apply(sampleOf(3.5, kPower | kMoveDone, kServoOn | kAccelDone | kSlewDone, 20'100));
    EXPECT_EQ(command.at(atSeconds(3.5)), exactly(20'100));
}

TEST(CommandPosition, TheEndOfAPhaseTellsWhenALateCommandWasCarriedOut) {
    const auto afterALateStart = [] {
        CommandPosition command = holdingAt100();
        command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
        bus::CommandExecuted start = executedAt(2, StartMotion{});
        start.late = 20 * kServoTick;
        command.apply(start);
        return command;
    };
    const double accelerated = 2 + 512 * kTick;
    const TimePoint then = atSeconds(2 + 600 * kTick);
    // It accelerates for 512 ticks; its start is known to within 20 ticks.
    CommandPosition unknowing = afterALateStart();
    EXPECT_GT(unknowing.at(then)->high - unknowing.at(then)->low, 20 * 8);
    CommandPosition early = afterALateStart();
    early.apply(sampleOf(accelerated + 2 * kTick, kPower, kServoOn | kAccelDone, 2'000));
    EXPECT_LT(early.at(then)->high - early.at(then)->low, 7 * 8);
    EXPECT_EQ(early.at(then)->high, unknowing.at(then)->high);
    CommandPosition late = afterALateStart();
    late.apply(sampleOf(accelerated + 18 * kTick, kPower, kServoOn, 2'000));
    EXPECT_LT(late.at(then)->high - late.at(then)->low, 8 * 8);
    EXPECT_EQ(late.at(then)->low, unknowing.at(then)->low);
}

TEST(CommandPosition, GoesByTheModuleWhereItContradictsTheClock) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, trapezoid(20'100, 8 << 16, 1'024)));
    command.apply(executedAt(2, StartMotion{}));
    const TimePoint then = atSeconds(2 + 900 * kTick);
    const CommandEstimate before = *command.at(then);
    // It should have accelerated for 512 ticks.
    command.apply(sampleOf(2 + 612 * kTick, kPower, kServoOn, 2'000));
    const CommandEstimate shifted = *command.at(then);
    EXPECT_NEAR(shifted.position, before.position - 100 * 8, 5 * 8);
    // The start is 98 ticks later: the clocks have drifted apart by 0.01 % of 98 x 8 counts less, both ways.
    EXPECT_NEAR(shifted.high - shifted.low, before.high - before.low - 2 * 0.0784, 0.01);
}

TEST(CommandPosition, ALoadThatWaitsChangesNothing) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(0, velocityMode(4 << 16, 1'024)));
    CommandPosition loaded = command;
    auto other = velocityMode(9 << 16, 9'000);
    other.startNow = false;
    loaded.apply(executedAt(0.5, other));
    loaded.apply(executedAt(1, stopWith(servo::StopManner::Smoothly)));
    command.apply(executedAt(1, stopWith(servo::StopManner::Smoothly)));
    EXPECT_EQ(loaded.at(atSeconds(3)), command.at(atSeconds(3)));
}

TEST(CommandPosition, AStoppedMoveHasNoGoalToEndAt) {
    CommandPosition command;  // attached: unknown
    command.apply(sampleOf(0, kMoveDone | kPower, kServoOn, 100));
    command.apply(executedAt(1, trapezoid(500, 8 << 16, 1'024)));
    command.apply(executedAt(1, StartMotion{}));
    command.apply(executedAt(1.1, stopWith(servo::StopManner::Abruptly)));
    command.apply(sampleOf(1.2, kMoveDone | kPower, kServoOn, 200));
    EXPECT_FALSE(command.at(atSeconds(1.2)).has_value());
}

TEST(CommandPosition, AMotorThatMovedWhileItWasSwitchedOnIsHeldSomewhereOnItsWay) {
    CommandPosition command;
    command.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0, 90));
    command.apply(executedAt(0.01, stopWith(servo::StopManner::Abruptly)));
    command.apply(sampleOf(0.02, kMoveDone | kPosError | kPower, kServoOn, 100));
    EXPECT_EQ(command.at(atSeconds(1)), (CommandEstimate{95, 90, 100}));
}

/// DS-V 4.5: in velocity mode it goes on at the motor's velocity. From 20 counts/tick, which are 39 062
/// counts/s, it takes 20 x 19 / 2 = 190 counts to come to rest at 1 count/tick^2.
TEST(CommandPosition, AMotorThatASmoothStopSwitchedOnIsHeldThereOnlyIfItStood) {
    for (const bool stood : {true, false}) {
        CommandPosition command;
        command.apply(sampleOf(0, kMoveDone | kPosError | kPower, 0, stood ? 781 : 0));
        command.apply(executedAt(0.02, stopWith(servo::StopManner::Smoothly)));
        command.apply(stood ? sampleOf(0.02, kMoveDone | kPosError | kPower, kServoOn, 781)
                            : sampleOf(0.02, kPosError | kPower, kServoOn, 781));
        command.apply(sampleOf(0.05, kMoveDone | kPosError | kPower, kServoOn, stood ? 781 : 971));
        const auto held = command.at(atSeconds(1));
        EXPECT_EQ(held.has_value(), stood);
        EXPECT_EQ(held.value_or(exactly(781)), exactly(781));
    }
}

/// At 19 200 Bd with replies lost for 80 ms: the start was carried out, and only its answer was lost. Until
/// that is known, the statuses belong neither to the old motion nor to a known new one.
TEST(CommandPosition, AMotionThatNobodyKnowsOfYetIsAGap) {
    CommandPosition command = holdingAt100();
    command.apply(executedAt(1, velocityMode(44 << 16, 65'536)));
    command.apply(sampleOf(1.1, kMoveDone | kPower, kServoOn, 8'000));
    command.apply(executedAt(2, stopWith(servo::StopManner::Smoothly)));
    command.apply(sampleOf(2.5, kMoveDone | kPower, kServoOn, 87'000));
    const auto rest = command.at(atSeconds(2.6));
    ASSERT_TRUE(rest);
    // Started again at 9 s, which is reported only after the status of 9.1 s.
    command.apply(sampleOf(9.1, kPower, kServoOn, 87'100));
    EXPECT_FALSE(command.at(atSeconds(9.1)));
    command.apply(executedAt(9, velocityMode(44 << 16, 65'536)));
    command.apply(sampleOf(9.2, kMoveDone | kPower, kServoOn, 103'000));
    const auto runs = command.at(atSeconds(9.2));
    ASSERT_TRUE(runs);
    // 44 counts/tick at 1 count/tick^2: 44 ticks to full speed, which cover 44 x 45 / 2 = 990 counts; then
    // 390.625 - 44 ticks at full speed. The uncertainty is that at rest, plus a tick and a half for the new
    // start, as much for the status, and two clocks 100 ppm apart.
    EXPECT_NEAR(runs->position, rest->position + 990 + (0.2 / kTick - 44) * 44, 44);
    EXPECT_LT(runs->high - runs->low, rest->high - rest->low + 3 * 44 + 4);
}

TEST(CommandPosition, IsLostAfterAMotionThatNobodyEverExplains) {
    CommandPosition command = holdingAt100();
    command.apply(sampleOf(1, kPower, kServoOn, 200));
    EXPECT_FALSE(command.at(atSeconds(1)));
    command.apply(executedAt(2, stopWith(servo::StopManner::Abruptly)));
    command.apply(sampleOf(2.1, kMoveDone | kPower, kServoOn, 300));
    EXPECT_FALSE(command.at(atSeconds(2.1))) << "it is at rest, but its command position is unknown";
    command.apply(executedAt(3, trapezoid(1'000, 65'536, 65'536)));
    command.apply(executedAt(3.1, StartMotion{}));
    command.apply(sampleOf(5, kMoveDone | kPower, kServoOn, 1'000));
    EXPECT_EQ(command.at(atSeconds(5)), exactly(1'000));
}

}  // namespace
}  // namespace nmc
