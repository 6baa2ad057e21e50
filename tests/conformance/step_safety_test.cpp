// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 4.5 and 4.6: error checking, current limiting.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

TEST_P(PicStep, ErrorChecking1_ForwardMotionIsInhibitedWhileLimit1IsHigh) {
    parameters(k1x);
    set("limit1 1");
    run();
    EXPECT_FALSE(moving());
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    expectNoViolations();
}

TEST_P(PicStep, ErrorChecking2_ReverseMotionIsInhibitedWhileLimit2IsHigh) {
    parameters(k1x);
    set("limit2 1");
    run(true);
    EXPECT_FALSE(moving());
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    expectNoViolations();
}

TEST_P(PicStep, ErrorChecking3_RunningIntoALimitSwitchStopsTheMotion) {
    parameters(k1x);
    set("travel_max 400");
    set("travel_min -400");
    set("limits auto");
    for (const bool reverse : {false, true}) {
        run(reverse);
        static_cast<void>(secondsToStop());
        EXPECT_EQ(position(), reverse ? -400 : 400) << "half a step a tick";
        EXPECT_EQ(status(), 0x0CU) << "the amplifier stays on";
    }
}

TEST_P(PicStep, ErrorChecking4_ALimitSwitchOptionallyTurnsTheMotorOff) {
    parameters(k1x | kMotorOffAtLimit);
    set("travel_max 400");
    set("limits auto");
    run();
    static_cast<void>(secondsToStop());
    EXPECT_EQ(status(), 0x08U);
}

TEST_P(PicStep, ErrorChecking5_MotionBackOffALimitSwitchIsAllowed) {
    parameters(k1x);
    for (const bool reverse : {false, true}) {
        const std::string own = reverse ? "limit2" : "limit1";
        set(own + " 1");
        run(!reverse);
        EXPECT_NEAR(stepsIn(kEightSeconds), reverse ? 8'000 : -8'000, 1);
        stop(0x05);
        set(own + " 0");
    }
}

TEST_P(PicStep, ErrorChecking6_StoppingAtLimitsCanBeDisabled) {
    parameters(k1x | kIgnoreLimits);
    set("limit1 1");
    set("limit2 1");
    run();
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    stop(0x05);
    run(true);
    EXPECT_NEAR(stepsIn(kEightSeconds), -8'000, 1);
}

TEST_P(PicStep, ErrorChecking7_EstopHighStopsTheMotor) {
    parameters(k1x);
    for (const bool reverse : {false, true}) {
        run(reverse);
        set("estop 1");
        EXPECT_EQ(status(), 0x0CU);
        EXPECT_EQ(stepsIn(seconds(1)), 0);
        set("estop 0");
    }
}

TEST_P(PicStep, ErrorChecking8_EstopOptionallyTurnsTheMotorOff) {
    parameters(k1x | kMotorOffAtLimit);
    run();
    set("estop 1");
    EXPECT_EQ(status(), 0x08U);
}

TEST_P(PicStep, ErrorChecking9_TheEmergencyStopCanBeDisabled) {
    parameters(k1x | kIgnoreEstop);
    run();
    set("estop 1");
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    EXPECT_TRUE(amplifier());
}

TEST_P(PicStep, ErrorChecking10_WithoutDriverPowerTheAmplifierIsLoweredAndMotionTerminated) {
    parameters(k1x, 20);
    load({.position = 30'000, .speed = 120, .acceleration = 4});
    rig->wait(milliseconds(500));
    set("power 0");
    EXPECT_EQ(status(), 0x00U);
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStep, ErrorChecking11_ATemperatureBelowTheThresholdTurnsTheMotorOff) {
    parameters(k1x, 1, 200, 80, 100);
    run();
    set("analog 101");
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    set("analog 99");
    EXPECT_EQ(status(), 0x08U);
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStep, ErrorChecking12_TheTemperatureCanBeReadInNormalOperation) {
    parameters(k1x, 1, 200, 80, 100);
    run();
    for (const unsigned value : {200U, 150U}) {
        set("analog " + std::to_string(value));
        EXPECT_EQ(report().analog, value);
    }
    EXPECT_TRUE(moving());
}

TEST_P(PicStep, ErrorChecking13_AThresholdOf0DisablesTheThermalShutdown) {
    parameters(k1x, 1, 200, 80, 0);
    set("analog 0");
    run();
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    EXPECT_TRUE(amplifier());
}

// ---- 4.6 ----

TEST_P(PicStep, CurrentLimiting1_LimitsReachFrom0To255) {
    for (const unsigned limit : {0U, 255U}) {
        parameters(k1x, 1, limit, 255 - limit);
        EXPECT_EQ(truth<unsigned>("current_limit"), 255 - limit);
        run();
        EXPECT_EQ(truth<unsigned>("current_limit"), limit);
        stop(0x05);
        rig->wait(seconds(1));
    }
    expectNoViolations();
}

TEST_P(PicStep, CurrentLimiting2_AnIdleMotorHasTheHoldingLimit) {
    parameters(k1x, 1, 200, 80);
    EXPECT_EQ(truth<int>("current_limit"), 80);
    rig->wait(seconds(10));
    EXPECT_EQ(truth<int>("current_limit"), 80);
}

TEST_P(PicStep, CurrentLimiting3_StartingAMotionSwitchesToTheRunningLimit) {
    parameters(k1x, 1, 200, 80);
    load({.count = kCount, .start = false});
    EXPECT_EQ(truth<int>("current_limit"), 80);
    command(0x05);
    EXPECT_EQ(truth<int>("current_limit"), 200);
    rig->wait(seconds(10));
    EXPECT_EQ(truth<int>("current_limit"), 200);
}

TEST_P(PicStep, CurrentLimiting4_TheHoldingLimitResumesAQuarterSecondAfterTheStop) {
    parameters(k1x, 1, 200, 80);
    load({.position = 500, .count = kCount});
    static_cast<void>(secondsToStop());
    int ticks = 0;
    for (; truth<int>("current_limit") == 200 && ticks < 2'000; ++ticks)
        rig->wait(kTick);
    EXPECT_NEAR(toSeconds(kTick * ticks), 0.25, 0.01);
    EXPECT_EQ(truth<int>("current_limit"), 80);
}

}  // namespace
}  // namespace nmc::conformance
