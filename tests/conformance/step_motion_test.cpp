// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.1 to 4.3: the step timer, the velocity profile, the trapezoidal profile.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

// ---- 4.1: 65 536 - f / S + k, for two speeds S that divide f ----

TEST_P(PicStep, StepTimer1_At1xTheCountIs65536Less625000PerSpeedPlus2) {
    parameters(k1x);
    load({.count = 65'536 - 625 + 2});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 1'000, 1);
    load({.count = 65'536 - 12'500 + 2});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 50, 1);
    expectNoViolations();
}

TEST_P(PicStep, StepTimer2_At2xTheCountIs65536Less1250000PerSpeedPlus4) {
    parameters(k2x);
    load({.count = 65'536 - 625 + 4});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 2'000, 1);
    load({.count = 65'536 - 12'500 + 4});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 100, 1);
    expectNoViolations();
}

TEST_P(PicStep, StepTimer3_At4xTheCountIs65536Less2500000PerSpeedPlus8) {
    parameters(k4x);
    load({.count = 65'536 - 625 + 8});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 4'000, 1);
    load({.count = 65'536 - 12'500 + 8});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 200, 1);
    expectNoViolations();
}

TEST_P(PicStep, StepTimer4_At8xTheCountIs65536Less5000000PerSpeedPlus16) {
    parameters(k8x);
    load({.count = 65'536 - 625 + 16});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 8'000, 1);
    load({.count = 65'536 - 12'500 + 16});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 400, 1);
    expectNoViolations();
}

TEST_P(PicStep, StepTimer5_TheLargestCountIs65452) {
    parameters(k8x);
    load({.count = 65'452});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 50'000, 1) << "5 MHz / (84 + 16)";
    expectNoViolations();
    load({.count = 65'453});
    expectViolations({"out_of_range"});
}

TEST_P(PicStep, StepTimer6_TheSmallestCountIs1) {
    parameters(k1x);
    load({.count = 1});
    // 625 000 / 65 537 = 9.5366 steps per second: 762.9 in 80 seconds.
    EXPECT_NEAR(stepsIn(kEightSeconds * 10), 763, 1);
    expectNoViolations();
    load({.count = 0});
    expectViolations({"out_of_range"});
}

TEST_P(PicStep, StepTimer7_TheTimerIsReloadedWithTheCountAfterEachStep) {
    parameters(k1x);
    run();
    for (int i = 0; i < 10; ++i)
        EXPECT_NEAR(stepsIn(k125Ticks), 64, 1) << "1000 steps per second for 64 ms";
    EXPECT_EQ(report().timerCount, 64'913U);
}

TEST_P(PicStep, StepTimer8_TheDirectionBitSetsTheDirection) {
    parameters(k1x);
    for (const bool reverse : {false, true}) {
        run(reverse);
        EXPECT_NEAR(stepsIn(kEightSeconds), reverse ? -8'000 : 8'000, 1);
        stop(0x05);
    }
    expectNoViolations();
}

TEST_P(PicStep, StepTimer9_WithAStoppingPositionItStopsThereAbruptly) {
    parameters(k1x);
    for (const std::int32_t goal : {2'000, -1'000}) {
        const auto from = static_cast<double>(position());
        rig->send(
            packet(1, 0x84,
                   Bytes{0x89} + little(static_cast<std::uint32_t>(goal), 4) + Bytes{0x91, 0xFD, kNearest}));
        rig->waitTicks(14);  // 12 bytes take 6.25 ms
        ASSERT_TRUE(moving());
        EXPECT_EQ(std::abs(truth<double>("step_rate")), 1'000);
        EXPECT_NEAR(secondsToStop(), std::abs(goal - from) / 1'000, 0.002);
        EXPECT_EQ(report().position, goal);
        EXPECT_EQ(stepsIn(seconds(1)), 0);
    }
    expectNoViolations();
}

TEST_P(PicStep, StepTimer10_AnotherDirectionNeedsAStopFirst) {
    parameters(k1x);
    run();
    run(true);
    expectViolations({"direction_change"});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    stop(0x05);
    run(true);
    EXPECT_NEAR(stepsIn(kEightSeconds), -8'000, 1);
    expectViolations({"direction_change"});
}

// ---- 4.2 ----

TEST_P(PicStep, VelocityProfile1_At1xTheStepIs25AndTheMaximum6250) {
    parameters(k1x);
    load({.speed = 1, .acceleration = 1});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 25, 1);
    load({.speed = 250});
    rig->wait(milliseconds(64));  // 249 x 0.25 ms
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 6'250, 1);
    EXPECT_EQ(report().timerCount, 65'536U - 100 + 2);
}

TEST_P(PicStep, VelocityProfile2_At2xTheStepIs50AndTheMaximum12500) {
    parameters(k2x);
    load({.speed = 1, .acceleration = 1});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 50, 1);
    load({.speed = 250});
    rig->wait(milliseconds(64));
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 12'500, 1);
    EXPECT_EQ(report().timerCount, 65'536U - 100 + 4);
}

TEST_P(PicStep, VelocityProfile3_At4xTheStepIs100AndTheMaximum25000) {
    parameters(k4x);
    load({.speed = 1, .acceleration = 1});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 100, 1);
    load({.speed = 250});
    rig->wait(milliseconds(64));
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 25'000, 1);
    EXPECT_EQ(report().timerCount, 65'536U - 100 + 8);
}

TEST_P(PicStep, VelocityProfile4_At8xTheStepIs200AndTheMaximum50000) {
    parameters(k8x);
    load({.speed = 1, .acceleration = 1});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 200, 1);
    load({.speed = 250});
    rig->wait(milliseconds(64));
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 50'000, 1);
    EXPECT_EQ(report().timerCount, 65'536U - 100 + 16);
}

TEST_P(PicStep, VelocityProfile5_SpeedsAreWholeNumbersFrom1To250) {
    parameters(k1x);
    load({.speed = 1, .acceleration = 1});
    load({.speed = 250});
    expectNoViolations();
    load({.speed = 0});
    load({.speed = 251});
    expectViolations({"out_of_range", "out_of_range"});
}

TEST_P(PicStep, VelocityProfile6_TheDirectionBitSetsTheDirection) {
    parameters(k1x, 40);
    for (const bool reverse : {true, false}) {
        load({.speed = 40, .acceleration = 1, .reverse = reverse});
        EXPECT_NEAR(stepsIn(kEightSeconds), reverse ? -8'000 : 8'000, 1);
        stop(0x05);
    }
    expectNoViolations();
}

TEST_P(PicStep, VelocityProfile7_AcceleratesByOneSpeedAfterAnother) {
    parameters(k1x, 10);
    load({.speed = 60, .acceleration = 8});  // 2 ms, four ticks, for each
    for (unsigned last = speed(); last != 60; last = speed()) {
        rig->wait(kTick);
        ASSERT_TRUE(speed() == last || speed() == last + 1) << last << " to " << speed();
    }
    rig->wait(seconds(1));
    EXPECT_EQ(speed(), 60U);
}

TEST_P(PicStep, VelocityProfile8_DeceleratesByOneSpeedAfterAnother) {
    parameters(k1x, 10);
    load({.count = kCount, .nearest = 60});
    load({.speed = 20, .acceleration = 8});
    for (unsigned last = speed(); last != 20; last = speed()) {
        rig->wait(kTick);
        ASSERT_TRUE(speed() == last || speed() + 1 == last) << last << " to " << speed();
    }
    rig->wait(seconds(1));
    EXPECT_EQ(speed(), 20U);
}

TEST_P(PicStep, VelocityProfile9_From25To125WithAnAccelerationTimeOf4Takes100Milliseconds) {
    parameters(k1x, 25);
    load({.speed = 25, .acceleration = 4});
    rig->send(packet(1, 0x24, {0x82, 125}));
    static_cast<void>(secondsToSpeed(26));  // the first millisecond has passed
    EXPECT_NEAR(secondsToSpeed(125), 0.099, 0.0006);
}

TEST_P(PicStep, VelocityProfile10_AnotherDirectionNeedsAStopFirst) {
    parameters(k1x, 40);
    load({.speed = 40, .acceleration = 1});
    load({.reverse = true});
    expectViolations({"direction_change"});
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    stop(0x09);
    load({.speed = 40, .reverse = true});
    EXPECT_NEAR(stepsIn(kEightSeconds), -8'000, 1);
    expectViolations({"direction_change"});
}

// ---- 4.3 ----
// From 20 to 120 at 1 ms each and 25 steps per second: (20 + ... + 119) x 0.025 = 173.75 steps in 0.1 s, and
// as many on the way down; the rest of 2000 takes 1652.5 / 3000 = 0.551 s.

TEST_P(PicStep, Trapezoid1_AcceleratesSlewsAndDeceleratesToAStopAtTheGoal) {
    parameters(k1x, 20);
    rig->send(packet(1, 0x74, {0x87, 0xD0, 0x07, 0, 0, 120, 4}));
    while (!moving())
        rig->wait(kTick);
    EXPECT_EQ(speed(), 20U);
    unsigned fastest = 0;
    double elapsed = 0;
    for (; moving() && elapsed < 2; elapsed += toSeconds(kTick)) {
        fastest = std::max(fastest, speed());
        rig->wait(kTick);
    }
    EXPECT_EQ(fastest, 120U);
    EXPECT_NEAR(elapsed, 0.751, 0.003);
    EXPECT_EQ(report().position, 2'000);
    EXPECT_EQ(status(), 0x0CU);
    EXPECT_EQ(stepsIn(std::chrono::seconds(1)), 0);
    expectNoViolations();
}

TEST_P(PicStep, Trapezoid2_TheRunningSpeedIsThatOfTheVelocityProfile) {
    parameters(k1x, 20);
    load({.position = 2'000, .speed = 120, .acceleration = 4});
    rig->wait(milliseconds(200));
    EXPECT_EQ(status() & 0x71U, 0x51U) << "moving, at speed, in a trapezoid";
    EXPECT_NEAR(stepsIn(k125Ticks), 0.064 * 3'000, 1);
}

TEST_P(PicStep, Trapezoid3_TheAccelerationTimeIsThatOfTheVelocityProfile) {
    parameters(k1x, 20);
    rig->send(packet(1, 0x74, {0x87, 0xD0, 0x07, 0, 0, 120, 4}));
    static_cast<void>(secondsToSpeed(21));
    EXPECT_NEAR(secondsToSpeed(120), 0.099, 0.0006);
}

TEST_P(PicStep, Trapezoid4_DeceleratesAtTheRateOfTheAcceleration) {
    parameters(k1x, 20);
    load({.position = 2'000, .speed = 120, .acceleration = 4});
    static_cast<void>(secondsToSpeed(120));
    static_cast<void>(secondsToSpeed(119));
    EXPECT_NEAR(static_cast<double>(position()), 2'000 - 173.75, 3);
    EXPECT_NEAR(secondsToSpeed(20), 0.099, 0.0006);
    // The rest of a step at 500 per second.
    EXPECT_LT(secondsToStop(), 0.005);
    EXPECT_EQ(position(), 2'000);
}

TEST_P(PicStep, Trapezoid5_MovesToAnyGoalInItsDirection) {
    parameters(k1x, 20);
    load({.speed = 120, .acceleration = 4, .start = false});
    for (const std::int32_t goal : {-2'000, 1, 0, 350, 347, -1}) {
        load({.position = goal});
        static_cast<void>(secondsToStop());
        EXPECT_EQ(report().position, goal);
    }
    expectNoViolations();
}

}  // namespace
}  // namespace nmc::conformance
