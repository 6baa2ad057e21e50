// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/model/stepperfixture.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr unsigned kRuns = kStepOn | kMoving | kVelocityMode;

TEST(StepperState, BeginsUnknownAndThenIsOffWithoutAFault) {
    Stepper stepper;
    EXPECT_EQ(stepper.module.activity(), Activity::Unknown);
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), Activity::AmplifierOff);
    EXPECT_EQ(severityOf(stepper.module.activity()), Severity::Normal);
    stepper.says(0);
    EXPECT_EQ(stepper.module.activity(), Activity::NoPower);
}

TEST(StepperState, HoldsOnceItIsEnabled) {
    const Stepper stepper = Stepper::holding();
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
    EXPECT_TRUE(stepper.module.driveOn());
    EXPECT_FALSE(stepper.module.servoOn());
    EXPECT_FALSE(stepper.module.moving());
}

// The answer to the start was composed before the motion began, and still reports standstill.
TEST(StepperState, MovesFromTheStartOnAlthoughItsAnswerDoesNotSayIt) {
    Stepper stepper = Stepper::holding();
    stepper.was(Stepper::trapezoid(1'000));
    EXPECT_TRUE(stepper.module.loadWaiting);
    EXPECT_FALSE(stepper.module.moving());
    stepper.was(StartMotion{});
    EXPECT_FALSE(stepper.module.loadWaiting);
    EXPECT_TRUE(stepper.module.moving());
    EXPECT_EQ(stepper.module.activity(), Activity::Accelerating);
    EXPECT_EQ(stepper.module.stepper.mode(), StepperMode::Trapezoidal);
    stepper.position = 1'000;
    stepper.says(kStepOn);
    EXPECT_FALSE(stepper.module.moving()) << "the later status ends the motion";
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

TEST(StepperState, TellsThePhasesOfARampByBitAndTimerCount) {
    Stepper stepper = Stepper::holding();
    stepper::LoadTrajectory load = Stepper::trapezoid(1'000);
    load.startNow = true;
    stepper.was(load);
    constexpr unsigned kMove = kStepOn | kMoving | kTrapezoidalMode;
    stepper.timer = 61'000;
    stepper.says(kMove);
    stepper.timer = 62'000;
    stepper.says(kMove);
    EXPECT_EQ(stepper.module.activity(), Activity::Accelerating);
    stepper.says(kMove | kAtSpeed);
    EXPECT_EQ(stepper.module.activity(), Activity::AtSpeed);
    stepper.timer = 61'500;
    stepper.says(kMove);
    EXPECT_EQ(stepper.module.activity(), Activity::Decelerating);
}

TEST(StepperState, KnowsTheDirectionOfWhatItWasTold) {
    EXPECT_EQ(Stepper::holding().module.stepper.runsReverse(), std::nullopt);
    EXPECT_EQ(Stepper::running().module.stepper.runsReverse(), false);
    EXPECT_EQ(Stepper::running(true).module.stepper.runsReverse(), true);
    Stepper stepper = Stepper::holding();
    stepper.position = 500;
    stepper.says(kStepOn);
    stepper::LoadTrajectory load = Stepper::trapezoid(100);
    load.startNow = true;
    stepper.was(load);
    EXPECT_EQ(stepper.module.stepper.runsReverse(), true) << "from 500 to 100";
}

TEST(StepperState, KnowsNeitherDirectionNorOutputsOfAChainThatItFound) {
    Stepper stepper;
    stepper.module.attached();
    stepper.says(kStepOn | kMoving);
    EXPECT_TRUE(stepper.module.moving());
    EXPECT_EQ(stepper.module.stepper.mode(), StepperMode::Unknown);
    EXPECT_EQ(stepper.module.stepper.runsReverse(), std::nullopt);
    EXPECT_EQ(stepper.module.stepper.outputs, std::nullopt);
    EXPECT_EQ(stepper.module.stepper.parameters, std::nullopt);
}

// DS-S 2.3: outputs 1-4 are initialized low, output 5 high.
TEST(StepperState, KnowsTheOutputsOfAFreshModuleAndThoseThatWereSet) {
    Stepper stepper;
    EXPECT_EQ(stepper.module.stepper.outputs, 0x10);
    stepper.was(stepper::SetOutputs{0x05});
    EXPECT_EQ(stepper.module.stepper.outputs, 0x05);
    stepper.module.restarted();
    EXPECT_EQ(stepper.module.stepper.outputs, std::nullopt);
    EXPECT_EQ(stepper.module.activity(), Activity::Restarted);
}

TEST(StepperState, SlowsDownAfterASmoothStop) {
    Stepper stepper = Stepper::running();
    stepper.wasStopped(stepper::StopManner::Smoothly);
    stepper.says(kRuns);
    EXPECT_EQ(stepper.module.activity(), Activity::Decelerating);
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

TEST(StepperState, SaysThatALimitEndedTheMotionUntilTheNextCommand) {
    Stepper stepper = Stepper::running();
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::StoppedByLimit);
    EXPECT_EQ(severityOf(Activity::StoppedByLimit), Severity::Attention);
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::StoppedByLimit);
    stepper.wasStopped(stepper::StopManner::Abruptly);
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

TEST(StepperState, DoesNotBlameALimitOfTheOtherDirection) {
    Stepper stepper = Stepper::running(true);
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

TEST(StepperState, DoesNotBlameALimitForOurOwnStop) {
    Stepper stepper = Stepper::running();
    stepper.wasStopped(stepper::StopManner::Abruptly);
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

TEST(StepperState, ShowsTheEstopInputWhereItActs) {
    Stepper stepper = Stepper::holding();
    stepper.inputs = kEstopIn;
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.activity(), Activity::EstopActive);
    stepper::SetParameters ignoring = Stepper::parameters();
    ignoring.ignoreEstop = true;
    stepper.was(ignoring);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
}

struct OffCase {
    const char* name;
    unsigned status;
    std::uint8_t inputs;
    std::uint8_t analog;
    Activity expected;
};
class StepperStateOff : public testing::TestWithParam<OffCase> {};

TEST_P(StepperStateOff, SaysWhatSwitchedTheMotorOff) {
    Stepper stepper = Stepper::running();
    stepper::SetParameters parameters = Stepper::parameters();
    parameters.thermalLimit = 80;
    parameters.motorOffOnLimitOrEstop = true;
    stepper.was(parameters);
    stepper.inputs = GetParam().inputs;
    stepper.analog = GetParam().analog;
    stepper.says(GetParam().status);
    EXPECT_FALSE(stepper.module.switchedItselfOff) << "one answer is not enough";
    stepper.says(GetParam().status);
    EXPECT_EQ(stepper.module.activity(), GetParam().expected);
    EXPECT_TRUE(stepper.module.switchedItselfOff);
    EXPECT_EQ(stepper.module.powerLostWhileOn, GetParam().expected == Activity::PowerLost);
    // It stays that way after the cause is gone, until a stop is sent.
    stepper.inputs = 0;
    stepper.analog = 200;
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), GetParam().expected);
    stepper.wasStopped(stepper::StopManner::Abruptly, false);
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), Activity::AmplifierOff);
    EXPECT_FALSE(stepper.module.switchedItselfOff);
}

INSTANTIATE_TEST_SUITE_P(Causes, StepperStateOff,
                         testing::Values(OffCase{"Power", 0, 0, 200, Activity::PowerLost},
                                         OffCase{"Heat", kStepPower, 0, 79, Activity::Overheated},
                                         OffCase{"Estop", kStepPower, kEstopIn, 80, Activity::EstopActive},
                                         OffCase{"Limit", kStepPower, kLimit2In, 80,
                                                 Activity::StoppedByLimit},
                                         OffCase{"Unknown", kStepPower, 0, 80, Activity::WentOff}),
                         [](const auto& one) { return std::string(one.param.name); });

/// The answer may be old, damaged, or that of another module: the next one shows that the motor is on.
TEST(StepperState, OneAnswerThatItIsOffIsADoubtThatTheNextEnds) {
    Stepper stepper = Stepper::running();
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), Activity::MaybeOff);
    EXPECT_FALSE(stepper.module.switchedItselfOff);
    stepper.says(kRuns);
    EXPECT_EQ(stepper.module.stepper.ended(), std::nullopt);
    EXPECT_EQ(severityOf(stepper.module.activity()), Severity::Normal);
    // Two answers report that it is off, and a third one does not.
    stepper.says(kStepPower);
    stepper.says(kStepPower);
    EXPECT_EQ(stepper.module.activity(), Activity::WentOff);
    stepper.says(kRuns);
    EXPECT_FALSE(stepper.module.switchedItselfOff);
    EXPECT_EQ(stepper.module.stepper.ended(), std::nullopt);
    EXPECT_NE(stepper.module.activity(), Activity::WentOff);
}

TEST(StepperState, MotorOffAtHomeIsNoFault) {
    Stepper stepper = Stepper::running();
    stepper::SetHoming homing;
    homing.onHomeSwitchChange = homing.motorOff = true;
    stepper.was(homing);
    stepper.says(kRuns | kStepHoming);
    stepper.says(kStepPower);
    EXPECT_FALSE(stepper.module.switchedItselfOff);
    EXPECT_EQ(stepper.module.activity(), Activity::AmplifierOff);
}

/// That the search is over is believed one reply later than that the motor is off (bus/trust.h).
TEST(StepperState, MotorOffAtHomeIsNoFaultBeforeTheSearchIsSeenToBeOver) {
    Stepper stepper = Stepper::running();
    stepper::SetHoming homing;
    homing.onHomeSwitchChange = homing.motorOff = true;
    stepper.was(homing);
    stepper.says(kRuns | kStepHoming);
    stepper.says(kStepPower | kStepHoming);
    for (int reply = 0; reply < 3; ++reply) {
        stepper.says(kStepPower);
        EXPECT_FALSE(stepper.module.switchedItselfOff) << reply;
        EXPECT_EQ(stepper.module.activity(), Activity::AmplifierOff) << reply;
    }
}

/// Without a condition, Set Homing Mode cancels the search (protocol.md 2).
TEST(StepperState, ASearchThatIsCancelledDoesNotExplainThatTheMotorIsOff) {
    Stepper stepper = Stepper::running();
    stepper::SetHoming cancel;
    cancel.motorOff = true;
    stepper.was(cancel);
    stepper.says(kRuns);
    stepper.says(kStepPower);
    stepper.says(kStepPower);
    EXPECT_TRUE(stepper.module.switchedItselfOff);
    EXPECT_EQ(stepper.module.activity(), Activity::WentOff);
}

/// DS-S 5.1: a smooth stop sets the goal speed to zero, "in the specified manner" also at home.
TEST(StepperState, ASmoothStopAtHomeLeavesNoSpeedLoaded) {
    for (const bool smooth : {false, true}) {
        SCOPED_TRACE(smooth);
        Stepper stepper = Stepper::running();
        stepper::SetHoming homing;
        homing.onHomeSwitchChange = true;
        homing.stopAbruptly = !smooth;
        homing.stopSmoothly = smooth;
        stepper.was(homing);
        stepper.was(Stepper::trapezoid(1'000));
        stepper.says(kRuns | kStepHoming);
        EXPECT_EQ(stepper.module.stepper.loadedSpeed, std::uint8_t{40});
        EXPECT_TRUE(stepper.module.loadWaiting);
        stepper.says(kStepOn);
        EXPECT_EQ(stepper.module.stepper.loadedSpeed, smooth ? std::uint8_t{0} : std::uint8_t{40});
        EXPECT_FALSE(stepper.module.loadWaiting);
        EXPECT_FALSE(stepper.module.stepper.waiting) << "as after a stop by command";
    }
}

TEST(StepperState, ASwitchThatWasLookedForIsNoLimitThatWasRunInto) {
    Stepper stepper = Stepper::running();
    stepper::SetHoming homing;
    homing.onLimit1Change = homing.stopAbruptly = true;
    stepper.was(homing);
    stepper.says(kRuns | kStepHoming);
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.stepper.ended(), std::nullopt);
    EXPECT_EQ(stepper.module.activity(), Activity::Holding);
    EXPECT_FALSE(stepper.module.limits.ranInto(0));
}

// DS-S 4.3: a motion towards a limit that is closed already ends at once.
TEST(StepperState, ALimitThatEndsAMotionIsNotedThoughItWasClosedBefore) {
    Stepper stepper = Stepper::holding();
    stepper.inputs = kLimit1In;
    stepper.says(kStepOn);
    EXPECT_FALSE(stepper.module.limits.ranInto(0)) << "closed by hand, at rest";
    stepper::LoadTrajectory load;
    load.speed = std::uint8_t{40};
    load.accelerationTime = std::uint8_t{4};
    load.startNow = true;
    stepper.was(load);
    stepper.says(kStepOn);
    EXPECT_EQ(stepper.module.stepper.ended(), Activity::StoppedByLimit);
    EXPECT_TRUE(stepper.module.limits.ranInto(0));
    EXPECT_FALSE(stepper.module.limits.ranInto(1));
    stepper.inputs = 0;
    stepper.says(kStepOn);
    EXPECT_FALSE(stepper.module.limits.ranInto(0));
}

// A speed value of 40 is another speed in another speed mode.
TEST(StepperState, ForgetsALoadWhenTheSpeedModeChanges) {
    Stepper stepper = Stepper::holding();
    stepper.was(Stepper::trapezoid(1'000));
    stepper::SetParameters faster = Stepper::parameters();
    faster.speedMode = stepper::SpeedMode::X8;
    stepper.was(faster);
    EXPECT_FALSE(stepper.module.loadWaiting);
}

// DS-S 5.1: a start takes what was loaded last, even by a load that was never started itself.
TEST(StepperState, AStartTakesOverTheAccelerationTimeThatWasLoadedLast) {
    Stepper stepper = Stepper::holding();
    stepper.was(Stepper::trapezoid(1'000));
    EXPECT_EQ(stepper.module.stepper.accelerationTime, std::nullopt) << "it is only loaded";
    stepper::LoadTrajectory run;
    run.timer = stepper::TimerCount{60'000, 20};
    stepper.was(run);
    stepper.was(StartMotion{});
    EXPECT_EQ(stepper.module.stepper.accelerationTime, std::uint8_t{4});
}

TEST(StepperState, HomeGoesAlongWithTheCounter) {
    Stepper stepper = Stepper::holding();
    stepper.position = -300;
    stepper.says(kStepOn);
    stepper.says(kStepOn);
    stepper.module.home.found(-300, stepper.time);
    stepper.was(ResetPosition{});
    ASSERT_TRUE(stepper.module.home.place());
    EXPECT_EQ(stepper.module.home.place()->counts, 0);
}

}  // namespace
}  // namespace nmc
