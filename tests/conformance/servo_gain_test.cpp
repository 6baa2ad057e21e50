// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2 Set Gain, with 4.3. Mostly with the shaft held at 0, so that the position error is determined by
// Stop Here or the velocity profile.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

class PicServoGain : public PicServo {
protected:
    PicServoGain() { block(); }
    /// Switches the servo on, with this position error.
    void error(std::int32_t counts) {
        servoOn({});
        stopHere(counts);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoGain, kPlaces, nameOf);

TEST_P(PicServoGain, SetGain1_Bytes1And2AreThePositionGain) {
    error(100);
    gains({.kp = 256});
    EXPECT_EQ(truth("pwm"), 100);
    gains({.kp = 0x0180});
    EXPECT_EQ(truth("pwm"), 150);
    stopHere(-100);
    EXPECT_EQ(truth("pwm"), -150) << "the direction is the output's sign";
    expectNoViolation();
}

TEST_P(PicServoGain, SetGain2_Bytes3And4AreTheDerivativeGain) {
    servoOn({.kd = 0x0201});
    velocity(5 * kOne, 5 * kOne);
    EXPECT_EQ(truth("pwm"), 10) << "the error grows by 5 every tick, and 513 * 5 / 256 is 10";
    velocity(-5 * std::int32_t{kOne}, 5 * kOne);
    rig->waitTicks(5);
    EXPECT_EQ(truth("pwm"), -10);
    stop(kAmplifier | kAbruptly);
    EXPECT_EQ(truth("pwm"), 0) << "a constant error has no derivative";
}

TEST_P(PicServoGain, SetGain3_Bytes5And6AreTheIntegralGain) {
    error(100);
    gains({.ki = 256, .il = 0x7FFF});
    const int before = truth("pwm");
    rig->waitTicks(256);
    EXPECT_EQ(truth("pwm"), before + 100) << "the running sum over 256";
    gains({.ki = 128, .il = 0x7FFF});
    rig->waitTicks(100);
    const int half = truth("pwm");
    rig->waitTicks(128);
    EXPECT_NEAR(truth("pwm"), half + 25, 1);
}

TEST_P(PicServoGain, SetGain4_Bytes7And8AreTheIntegrationLimitTimes256) {
    error(100);
    gains({.ki = 256, .il = 0x0102 - 0xF8});
    rig->waitTicks(500);
    EXPECT_EQ(truth("pwm"), 10) << "the running sum stays at 10 * 256";
    gains({.ki = 64, .il = 0x0102});
    rig->waitTicks(1000);
    EXPECT_EQ(truth("pwm"), 0x0102 / 4);
}

TEST_P(PicServoGain, SetGain5_TheRunningSumItselfIsBounded) {
    error(100);
    gains({.ki = 256, .il = 10});
    rig->waitTicks(5000);
    stopHere(-100);
    // 2560 / 100 is 25.6 ticks to zero, and as many again to the other bound.
    rig->waitTicks(60);
    EXPECT_EQ(truth("pwm"), -10);
}

TEST_P(PicServoGain, SetGain6_AnIntegrationLimitOf0EmptiesTheRunningSum) {
    error(100);
    gains({.ki = 256, .il = 10});
    rig->waitTicks(500);
    stopHere(0);
    EXPECT_EQ(truth("pwm"), 10) << "what has been summed remains";
    gains({.ki = 256, .il = 0});
    gains({.ki = 256, .il = 10});
    rig->waitTicks(10);
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(PicServoGain, SetGain7_Byte9LimitsTheOutput) {
    error(100);
    gains({.kp = 256, .ol = 60});
    EXPECT_EQ(truth("pwm"), 60);
    stopHere(-100);
    EXPECT_EQ(truth("pwm"), -60);
    gains({.kp = 256, .ol = 0});
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(PicServoGain, SetGain8_AnOddByte10IsAnUpperBoundOfTheCurrentSense) {
    error(100);
    rig->must("set 1 analog 99");
    gains({.kp = 256, .cl = 101});
    rig->waitTicks(50);
    EXPECT_EQ(truth("current_limit_adjustment"), 0);
    rig->must("set 1 analog 102");
    rig->waitTicks(50);
    EXPECT_EQ(truth("current_limit_adjustment"), 50);
}

TEST_P(PicServoGain, SetGain9_AnEvenByte10IsALowerBoundOfTheCurrentSense) {
    error(100);
    rig->must("set 1 analog 101");
    gains({.kp = 256, .cl = 100});
    rig->waitTicks(50);
    EXPECT_EQ(truth("current_limit_adjustment"), 0);
    rig->must("set 1 analog 99");
    rig->waitTicks(50);
    EXPECT_EQ(truth("current_limit_adjustment"), 50);
}

TEST_P(PicServoGain, SetGain10_ACurrentLimitOf0IsNone) {
    error(100);
    gains({.kp = 256, .cl = 0});
    for (const char* value : {"0", "255"}) {
        rig->must(std::string("set 1 analog ") + value);
        rig->waitTicks(50);
        EXPECT_EQ(truth("pwm"), 100);
        EXPECT_EQ(status().byte & kOvercurrent, 0U);
    }
}

TEST_P(PicServoGain, SetGain11_CurrentLimitingTakesOneFromThePwmPerTickAndGivesItBack) {
    error(100);
    rig->must("set 1 analog 0");
    gains({.kp = 256, .ol = 80, .cl = 101});
    EXPECT_EQ(truth("pwm"), 80);
    rig->must("set 1 analog 200");
    for (const int left : {60, 40, 20, 0, 0}) {
        rig->waitTicks(20);
        EXPECT_EQ(truth("pwm"), left) << "down to 0, but not below";
    }
    rig->must("set 1 analog 0");
    for (const int left : {20, 40, 60, 80, 80}) {
        rig->waitTicks(20);
        EXPECT_EQ(truth("pwm"), left) << "at most the original value";
    }
}

TEST_P(PicServoGain, SetGain12_Bytes11And12AreThePositionErrorLimit) {
    servoOn({.el = 0x0132});
    stopHere(0x0132);
    EXPECT_EQ(truth("servo_on"), true) << "the error is not larger than the limit";
    stopHere(0x0133);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(status().byte & kPositionError, kPositionError);
    servoOn({.el = 0x0132});
    stopHere(-0x0133);
    EXPECT_EQ(truth("servo_on"), false) << "its magnitude counts";
}

TEST_P(PicServoGain, SetGain13_Byte13DividesTheServoRate) {
    error(100);
    // At 651 Hz the running sum takes three times as long as in SetGain3.
    gains({.ki = 256, .il = 0x7FFF, .sr = 3});
    const int before = truth("pwm");
    rig->waitTicks(3 * 128);
    EXPECT_EQ(truth("pwm"), before + 50);
}

TEST_P(PicServoGain, SetGain14_TheServoRateIsTheProfilesTimebaseToo) {
    servoOn({.sr = 3});
    velocity(kOne, kOne);
    const double before = number("command_position");
    rig->waitTicks(300);
    EXPECT_EQ(number("command_position") - before, 100);
}

TEST_P(PicServoGain, SetGain15_CommandsAreProcessedAtTheMaximumRate) {
    start("servo", 1, {"--unpaced"});
    gains({.sr = 255});
    for (int i = 0; i < 10; ++i) {
        rig->send(packet(1, 0x0E));
        // Four bytes at 19 200 Bd and a tick of 0.512 ms.
        EXPECT_EQ(rig->wait(std::chrono::microseconds(2'084) + kTick).size(), 2U);
    }
}

TEST_P(PicServoGain, SetGain16_CurrentIsLimitedAtTheMaximumRate) {
    error(100);
    rig->must("set 1 analog 0");
    gains({.kp = 256, .cl = 101, .sr = 255});
    rig->waitTicks(255);
    ASSERT_EQ(truth("pwm"), 100);
    rig->must("set 1 analog 200");
    rig->waitTicks(30);
    EXPECT_EQ(truth("pwm"), 70);
}

TEST_P(PicServoGain, SetGain17_Byte14CompensatesTheDeadband) {
    error(2);
    gains({.kp = 256, .db = 30});
    EXPECT_EQ(truth("pwm"), 32);
    stopHere(-2);
    EXPECT_EQ(truth("pwm"), -32) << "added to the magnitude";
}

TEST_P(PicServoGain, SetGain18_WithThirteenBytesVersion4TakesADeadbandOf0) {
    error(2);
    gains({.kp = 256, .db = 30});
    Bytes thirteen = gainBytes({.kp = 256, .db = 30});
    thirteen.pop_back();
    EXPECT_EQ(command(0xD6, thirteen).size(), 2U);
    EXPECT_EQ(truth("pwm"), 2);
    expectNoViolation();
}

TEST_P(PicServoGain, SetGain19_VersionsBefore4IgnoreTheFourteenthByte) {
    for (const char* version : {"servo@1", "servo@2", "servo@3"}) {
        start(version, 1);
        block();
        servoOn({.kp = 256, .db = 30});
        velocity(kOne, kOne);
        EXPECT_EQ(truth("pwm"), number("command_position")) << version;
        expectNoViolation();
    }
}

TEST_P(PicServoGain, SetGain20_VersionsBefore4TakeThirteenBytes) {
    for (const char* version : {"servo@1", "servo@2", "servo@3"}) {
        start(version, 1);
        Bytes thirteen = gainBytes({.kp = 1, .kd = 2, .ki = 3, .il = 4, .ol = 5, .cl = 6, .el = 7, .sr = 8});
        thirteen.pop_back();
        EXPECT_EQ(command(0xD6, thirteen).size(), 2U);
        const nlohmann::json wanted{{"kp", 1}, {"kd", 2}, {"ki", 3}, {"il", 4}, {"ol", 5},
                                    {"cl", 6}, {"el", 7}, {"sr", 8}, {"db", 0}};
        EXPECT_EQ(truth("gains"), wanted);
        expectNoViolation();
    }
}

TEST_P(PicServoGain, SetGain21_GainsAndLimitsHaveARange) {
    gains({.kp = 0x7FFF, .kd = 0x7FFF, .ki = 0x7FFF, .il = 0x7FFF, .el = 0x3FFF, .sr = 255, .db = 255});
    expectNoViolation();
    for (const Gains& wrong : {Gains{.kp = 0x8000}, Gains{.kd = 0x8000}, Gains{.ki = 0x8000},
                               Gains{.il = 0x8000}, Gains{.el = 0x4000}, Gains{.sr = 0}})
        gains(wrong);
    EXPECT_EQ(rig->violations(), std::vector<std::string>(6, "out_of_range"));
}

}  // namespace
}  // namespace nmc::conformance
