// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1: Load Trajectory, Start Motion.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

constexpr std::int32_t kMax = 0x7FFFFFFF;

class PicStepLoad : public PicStep {
protected:
    PicStepLoad() { parameters(k1x, 20); }
    std::string mode() { return truth<std::string>("mode"); }
    void arrive(std::int32_t goal) {
        static_cast<void>(secondsToStop());
        EXPECT_EQ(report().position, goal);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicStepLoad, kPlaces, nameOf);

TEST_P(PicStepLoad, LoadTrajectory1_IsCommand4With1To10BytesAsTheControlByteAnnounces) {
    EXPECT_EQ(command(0x14, {0x00}).size(), 2U);
    EXPECT_EQ(command(0xA4, {0x0F, 1, 0, 0, 0, 2, 3, 0x91, 0xFD, kNearest}).size(), 2U);
    EXPECT_EQ(rig->control("stats")["modules"][0]["executed"]["load_trajectory"], 2);
    expectNoViolations();
    command(0x34, {0x02, 30, 4});
    expectViolations({"wrong_length"});
    command(0x24, {0x06, 30});
    expectViolations({"wrong_length", "wrong_length"});
}

TEST_P(PicStepLoad, LoadTrajectory2_Bit0LoadsThePositionInFourBytes) {
    command(0x74, {0x87, 0x02, 0x01, 0, 0, 120, 4});
    arrive(0x0102);
    command(0x54, {0x81, 0xFE, 0xFF, 0xFF, 0xFF});
    arrive(-2);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory3_Bit1LoadsTheSpeedInOneByte) {
    command(0x24, {0x82, 40});
    rig->wait(seconds(1));
    EXPECT_EQ(speed(), 40U);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory4_Bit2LoadsTheAccelerationTimeInOneByte) {
    command(0x24, {0x02, 40});
    rig->send(packet(1, 0x24, {0x84, 200}));  // 50 ms
    static_cast<void>(secondsToSpeed(21));
    EXPECT_NEAR(secondsToSpeed(22), 0.05, 0.0006);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory5_Bit3LoadsTheTimerCountInThreeBytes) {
    command(0x44, {0x88, 0x91, 0xFD, kNearest});
    EXPECT_EQ(report().timerCount, 0xFD91U);
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory6_Bit4IsTheDirectionOfTheVelocityProfile) {
    for (const unsigned reverse : {0x00U, 0x10U}) {
        command(0x34, {static_cast<std::uint8_t>(0x86U | reverse), 20, 1});
        EXPECT_NEAR(stepsIn(kEightSeconds), reverse == 0 ? 4'000 : -4'000, 1);
        stop(0x05);
    }
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory7_Bits5And6AreNotUsed) {
    command(0x34, {0xE6, 20, 1});
    EXPECT_EQ(mode(), "velocity");
    EXPECT_NEAR(stepsIn(kEightSeconds), 4'000, 1);
    expectViolations({"reserved_bits"});
}

TEST_P(PicStepLoad, LoadTrajectory8_Bit7StartsTheMotionNow) {
    command(0x34, {0x06, 20, 1});
    EXPECT_FALSE(moving());
    command(0x34, {0x86, 20, 1});
    EXPECT_TRUE(moving());
}

TEST_P(PicStepLoad, LoadTrajectory9_DataComeInTheOrderOfTheBits) {
    command(0x74, {0x87, 0xE8, 0x03, 0, 0, 60, 4});
    rig->wait(milliseconds(100));
    EXPECT_EQ(speed(), 60U);
    arrive(1'000);
    // Speed 30 and acceleration time 255 (64 ms), then count FD91 and nearest speed 40.
    load({.position = 30'000, .speed = 60});
    command(0x64, {0x8E, 30, 255, 0x91, 0xFD, 40});
    EXPECT_EQ(speed(), 40U);
    EXPECT_NEAR(secondsToSpeed(39), 0.064, 0.018) << "it began up to 18 ms ago";
    static_cast<void>(secondsToSpeed(30));
    rig->wait(seconds(1));
    EXPECT_EQ(speed(), 30U);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory10_ThePositionIsTheGoalOfTheTrapezoidalProfile) {
    load({.position = 700, .speed = 120, .acceleration = 4});
    EXPECT_EQ(mode(), "trapezoidal");
    arrive(700);
}

TEST_P(PicStepLoad, LoadTrajectory11_ThePositionIsTheGoalOfTheUnprofiledPositionMode) {
    load({.position = 700, .count = kCount});
    EXPECT_EQ(mode(), "unprofiled");
    arrive(700);
}

TEST_P(PicStepLoad, LoadTrajectory12_PositionsReachFromMinus7FFFFFFFToPlus7FFFFFFF) {
    parameters(k8x, 250);
    load({.position = kMax, .speed = 250, .acceleration = 1});
    rig->wait(seconds(43'000));  // 2 147 483 647 / 50 000 = 42 949.7
    EXPECT_EQ(report().position, kMax);
    load({.position = 0});
    rig->wait(seconds(43'000));
    load({.position = -kMax});
    rig->wait(seconds(43'000));
    EXPECT_EQ(report().position, -kMax);
    expectNoViolations();
    load({.position = -kMax - 1});
    expectViolations({"out_of_range"});
}

TEST_P(PicStepLoad, LoadTrajectory13_TheGoalIsNoFartherThan7FFFFFFFFromThePosition) {
    parameters(k8x, 250);
    load({.position = -1'000, .speed = 250, .acceleration = 1});
    rig->wait(seconds(1));
    load({.position = kMax - 1'000});
    stop(0x05);
    expectNoViolations();
    load({.position = kMax});
    expectViolations({"out_of_range"});
}

TEST_P(PicStepLoad, LoadTrajectory14_SpeedsAreFrom1To250) {
    load({.speed = 1, .acceleration = 1, .start = false});
    load({.speed = 250, .start = false});
    expectNoViolations();
    load({.speed = 0, .start = false});
    load({.speed = 251, .start = false});
    expectViolations({"out_of_range", "out_of_range"});
}

TEST_P(PicStepLoad, LoadTrajectory15_TheSpeedIsTheGoalOfTheVelocityProfile) {
    load({.speed = 120, .acceleration = 4});
    rig->wait(milliseconds(100));
    EXPECT_NEAR(stepsIn(kEightSeconds), 24'000, 1);
}

TEST_P(PicStepLoad, LoadTrajectory16_TheSpeedIsTheMaximumOfTheTrapezoid) {
    load({.position = 30'000, .speed = 120, .acceleration = 4});
    rig->wait(milliseconds(100));
    EXPECT_NEAR(stepsIn(kEightSeconds), 24'000, 1);
}

TEST_P(PicStepLoad, LoadTrajectory17_ASpeedBelowTheMinimumProfileSpeedGivesTheMinimum) {
    for (const bool profile : {false, true}) {
        if (profile)
            load({.speed = 5, .acceleration = 4});
        else
            load({.position = 30'000, .speed = 5, .acceleration = 4});
        EXPECT_NEAR(stepsIn(kEightSeconds), 4'000, 1);
        stop(0x05);
    }
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory18_AccelerationTimesAreFrom1To255) {
    load({.acceleration = 1, .start = false});
    load({.acceleration = 255, .start = false});
    expectNoViolations();
    load({.acceleration = 0, .start = false});
    expectViolations({"out_of_range"});
}

TEST_P(PicStepLoad, LoadTrajectory19_TheAccelerationTimeHoldsInBothProfiles) {
    for (const bool trapezoid : {false, true}) {
        Load l{.speed = 60, .acceleration = 200};
        if (trapezoid)
            l.position = 30'000;
        load(l);
        static_cast<void>(secondsToSpeed(30));
        EXPECT_NEAR(secondsToSpeed(40), 0.5, 0.001);
        stop(0x05);
    }
}

TEST_P(PicStepLoad, LoadTrajectory20_TheCountIsFollowedByTheNearestIntegerSpeed) {
    command(0x44, {0x88, 0x91, 0xFD, 41});
    EXPECT_EQ(speed(), 41U);
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1) << "the count determines the speed";
}

TEST_P(PicStepLoad, LoadTrajectory21_RampsFromACountBeginAtTheNearestIntegerSpeed) {
    for (const unsigned goal : {50U, 30U}) {
        load({.count = kCount, .nearest = 40});
        load({.speed = static_cast<std::uint8_t>(goal), .acceleration = 200});  // 50 ms each
        EXPECT_EQ(speed(), 40U);
        rig->wait(milliseconds(275));
        EXPECT_EQ(speed(), goal > 40 ? 45U : 35U) << "286 to 292 ms after the command";
        stop(0x05);
    }
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory22_Bit4IsTheDirectionOfTheUnprofiledVelocityMode) {
    for (const unsigned reverse : {0x10U, 0x00U}) {
        command(0x44, {static_cast<std::uint8_t>(0x88U | reverse), 0x91, 0xFD, kNearest});
        EXPECT_NEAR(stepsIn(kEightSeconds), reverse == 0 ? 8'000 : -8'000, 1);
        stop(0x05);
    }
}

TEST_P(PicStepLoad, LoadTrajectory23_TheDirectionCannotBeChangedWithoutAStop) {
    load({.speed = 40, .acceleration = 1});
    load({.speed = 40, .reverse = true});
    load({.count = kCount, .reverse = true});
    expectViolations({"direction_change", "direction_change"});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
}

TEST_P(PicStepLoad, LoadTrajectory24_WithoutBit7NothingHappensUntilStartMotion) {
    load({.speed = 40, .acceleration = 1});
    load({.speed = 80, .start = false});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    command(0x05);
    rig->wait(milliseconds(20));
    EXPECT_NEAR(stepsIn(kEightSeconds), 16'000, 1);
}

TEST_P(PicStepLoad, LoadTrajectory25_BeforeStartMotionItMayBeOverwritten) {
    load({.speed = 80, .acceleration = 1, .start = false});
    load({.speed = 40, .start = false});
    command(0x05);
    rig->wait(milliseconds(20));
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory26_TheModeFollowsFromWhatIsLoaded) {
    load({.count = kCount});
    EXPECT_EQ(mode(), "unprofiled");
    stop(0x05);
    load({.position = 30'000, .count = kCount});
    EXPECT_EQ(mode(), "unprofiled");
    stop(0x05);
    load({.speed = 40, .acceleration = 1});
    EXPECT_EQ(mode(), "velocity");
    stop(0x05);
    load({.position = 30'000, .speed = 40});
    EXPECT_EQ(mode(), "trapezoidal");
    expectNoViolations();
}

TEST_P(PicStepLoad, LoadTrajectory27_AParameterThatIsNotLoadedKeepsItsValue) {
    load({.speed = 60, .acceleration = 200, .start = false});
    load({.position = 30'000});
    static_cast<void>(secondsToSpeed(30));
    EXPECT_NEAR(secondsToSpeed(40), 0.5, 0.001) << "acceleration time 200";
    rig->wait(seconds(2));
    EXPECT_EQ(speed(), 60U);
    stop(0x05);
    load({.speed = 40});
    static_cast<void>(secondsToSpeed(30));
    EXPECT_NEAR(secondsToSpeed(40), 0.5, 0.001);
}

// ---- Start Motion ----

TEST_P(PicStepLoad, StartMotion1_IsCommand5WithoutData) {
    expectForm("start_motion", 0x05, {});
}

TEST_P(PicStepLoad, StartMotion2_ExecutesTheMostRecentLoadTrajectory) {
    load({.position = 700, .count = kCount, .start = false});
    load({.position = -300, .count = kCount, .start = false});
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    EXPECT_EQ(command(0x05).size(), 2U);
    arrive(-300);
    expectNoViolations();
}

TEST_P(PicStepLoad, StartMotion3_ToAGroupStartsAllChipsAtOnceServosToo) {
    fresh("step,step,servo");
    for (const unsigned address : {1U, 2U}) {
        rig->command(address, 0x56, {k1x, 1, 0, 0, 0});
        rig->command(address, 0x44, {0x08, 0x91, 0xFD, kNearest});
    }
    rig->command(3, 0x24, {0x08, 100});  // PWM 100
    EXPECT_EQ(rig->state(3)["pwm"], 0);
    EXPECT_TRUE(rig->command(0xFF, 0x05).empty());
    EXPECT_EQ(rig->state(3)["pwm"], 100);
    const std::int64_t first = rig->state(1)["position"];
    EXPECT_GT(first, 10);
    EXPECT_NEAR(static_cast<double>(first), rig->state(2)["position"].get<double>(), 1);
    expectNoViolations();
}

}  // namespace
}  // namespace nmc::conformance
