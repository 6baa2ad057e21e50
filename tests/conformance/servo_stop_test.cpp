// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2: Reset Position, Stop Motor, I/O Control, Save Current Position as Home.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

TEST_P(PicServo, ResetPosition1_SetsThePositionCounterTo0) {
    turnAway();
    command(0x00);
    EXPECT_EQ(status().position, 0);
    EXPECT_GT(number("shaft"), 1000) << "the shaft stays where it is";
    expectNoViolation();
}

TEST_P(PicServo, ResetPosition2_SetsTheCommandPositionTo0SoThatTheMotorDoesNotJump) {
    servoOn();
    trapezoid(500, 4 * kOne, kOne / 16);
    rig->wait(milliseconds(500));
    const double shaft = number("shaft");
    EXPECT_NEAR(shaft, 500, 3);
    command(0x00);
    EXPECT_EQ(number("command_position"), 0);
    rig->wait(milliseconds(200));
    EXPECT_NEAR(number("shaft"), shaft, 4);
}

TEST_P(PicServo, ResetPosition3_MayHaveOneDataByte) {
    turnAway();
    EXPECT_EQ(command(0x10, {0x55}), (Bytes{0x19, 0x19}));
    EXPECT_EQ(status().position, 0);
    expectNoViolation();
}

TEST_P(PicServo, ResetPosition4_NotWhileExecutingATrapezoid) {
    servoOn();
    velocity(kOne, kOne);
    command(0x00);
    expectNoViolation();
    stop(kAmplifier | kAbruptly);
    trapezoid(1000, kOne, kOne);
    command(0x00);
    expectViolation("reset_in_motion");
}

TEST_P(PicServo, StopMotor1_Bit0IsAmpEnableWhateverTheOthers) {
    gains(kGoodGains);
    for (const unsigned manner : {0U, kMotorOff, kAbruptly, kSmoothly}) {
        stop(manner | kAmplifier);
        EXPECT_EQ(truth("amp_enabled"), true) << manner;
        stop(manner);
        EXPECT_EQ(truth("amp_enabled"), false) << manner;
    }
    stopHere(0);
    EXPECT_EQ(truth("amp_enabled"), true);
    command(0x57, Bytes{kHere} + position(0));
    EXPECT_EQ(truth("amp_enabled"), false);
    expectNoViolation();
}

TEST_P(PicServo, StopMotor2_Bit1DisablesTheServoAndMakesThePwmValue0) {
    servoOn();
    trapezoid(1000, 4 * kOne, kOne);
    stop(kAmplifier | kMotorOff);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("pwm"), 0);
    pwm(50);
    EXPECT_EQ(truth("pwm"), 50);
    stop(kAmplifier | kMotorOff);
    EXPECT_EQ(truth("pwm"), 0);
    expectNoViolation();
}

TEST_P(PicServo, StopMotor3_Bit1MakesBits2To4Ignored) {
    for (const unsigned manner : {kAbruptly, kSmoothly}) {
        servoOn();
        stop(kMotorOff | manner);
        EXPECT_EQ(truth("servo_on"), false);
    }
    servoOn();
    command(0x57, Bytes{kMotorOff | kHere} + position(100));
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(number("command_position"), number("position"));
    expectNoViolation();
    EXPECT_EQ(rig->remarks(), (std::vector<std::string>(3, "stop_bits")));
}

TEST_P(PicServo, StopMotor4_Bit2MakesTheCommandVelocity0AtOnceInVelocityMode) {
    servoOn();
    trapezoid(100'000, 3 * kOne, kOne);
    rig->waitTicks(100);
    stop(kAmplifier | kAbruptly);
    EXPECT_EQ(number("command_velocity"), 0);
    EXPECT_EQ(truth("mode"), "velocity");
    EXPECT_EQ(truth("servo_on"), true);
    const double there = number("command_position");
    rig->wait(milliseconds(300));
    EXPECT_EQ(number("command_position"), there);
    EXPECT_NEAR(number("shaft"), there, 3);
}

TEST_P(PicServo, StopMotor5_Bit2ServosADisabledMotorToItsCurrentPosition) {
    turnAway();
    gains(kGoodGains);
    stop(kAmplifier | kAbruptly);
    EXPECT_EQ(truth("servo_on"), true);
    EXPECT_EQ(truth("mode"), "velocity");
    EXPECT_EQ(number("command_position"), number("position"));
    expectNoViolation();
}

TEST_P(PicServo, StopMotor6_Bit3DeceleratesToAStopAtTheCurrentAcceleration) {
    servoOn();
    trapezoid(100'000, 4 * kOne, kOne / 64);
    rig->waitTicks(300);
    stop(kAmplifier | kSmoothly);
    EXPECT_EQ(truth("mode"), "velocity");
    const double v = number("command_velocity");
    EXPECT_LT(v, 4);
    EXPECT_GT(v, 3);
    const double from = number("command_position");
    rig->waitTicks(256);
    EXPECT_EQ(number("command_velocity"), 0);
    // (v - a) + (v - 2a) + ... + a.
    EXPECT_EQ(number("command_position") - from, v * v * 32 - v / 2);
    EXPECT_EQ(truth("servo_on"), true);
}

TEST_P(PicServo, StopMotor7_Bits2And3MakeTheGoalVelocity0) {
    for (const unsigned manner : {kAbruptly, kSmoothly}) {
        servoOn();
        velocity(kOne, kOne);
        stop(kAmplifier | manner);
        load(kServo | kVelocityProfile | kStart);
        rig->waitTicks(50);
        EXPECT_EQ(number("command_velocity"), 0) << "no velocity has been loaded since";
    }
    EXPECT_EQ(rig->violations(), (std::vector<std::string>(2, "velocity_not_loaded")));
}

TEST_P(PicServo, StopMotor8_Bit4MovesToTheStoppingPositionWithoutAProfile) {
    servoOn();
    rig->send(packet(1, 0x57, Bytes{kHere | kAmplifier} + position(-0x102)));
    while (number("command_position") == 0)
        rig->waitTicks(1);
    EXPECT_EQ(number("command_position"), -0x102);
    rig->wait(milliseconds(300));
    EXPECT_NEAR(number("shaft"), -0x102, 3);
    expectNoViolation();
}

TEST_P(PicServo, StopMotor9_Bit4IsNotAvailableOnVersion1) {
    start("servo@1", 1);
    servoOn();
    stopHere(100);
    EXPECT_EQ(number("command_position"), 0);
    expectViolation("unsupported");
    for (const char* version : {"servo@2", "servo@3"}) {
        start(version, 1);
        servoOn();
        stopHere(100);
        EXPECT_EQ(number("command_position"), 100) << version;
    }
}

TEST_P(PicServo, StopMotor10_TheStoppingPositionIsRequiredWithBit4Only) {
    stop(kAmplifier | kMotorOff);
    stopHere(0);
    expectNoViolation();
    stop(kAmplifier | kHere);
    expectViolation("wrong_length");
}

TEST_P(PicServo, StopMotor11_Bit4TracksAStringOfPositions) {
    servoOn();
    for (int goal = 10; goal <= 200; goal += 10) {
        stopHere(goal);
        EXPECT_EQ(number("command_position"), goal);
    }
    rig->wait(milliseconds(300));
    EXPECT_NEAR(number("shaft"), 200, 3);
    expectNoViolation();
}

TEST_P(PicServo, StopMotor12_AStoppingPositionTooFarAwayMakesAPositionError) {
    servoOn({.kp = 200, .kd = 2000, .el = 500});
    stopHere(501);
    const Status s = status();
    EXPECT_EQ(s.byte & kPositionError, kPositionError);
    EXPECT_EQ(s.auxiliary & kServoOn, 0U);
}

TEST_P(PicServo, StopMotor13_OnlyOneOfBits1To4IsSetAtATime) {
    gains(kGoodGains);
    stop(kAbruptly | kSmoothly);
    expectViolation("stop_bits");
}

TEST_P(PicServo, StopMotor14_AmpEnableMustBeSetBeforeAnythingMoves) {
    EXPECT_EQ(truth("amp_enabled"), false);
    pwm(255);
    rig->wait(milliseconds(100));
    EXPECT_EQ(number("shaft"), 0);
    stop(kAmplifier);
    rig->wait(milliseconds(100));
    EXPECT_GT(number("shaft"), 1000);
}

TEST_P(PicServo, StopMotor15_Bits5To7AreToBeCleared) {
    stop(kAmplifier | 0x20);
    EXPECT_EQ(truth("amp_enabled"), true);
    expectViolation("reserved_bits");
}

TEST_P(PicServo, StopMotor16_OutOfPwmModeItDeceleratesAtTheAccelerationExecutedLast) {
    gains(kGoodGains);
    stop(kAmplifier | kMotorOff);
    load(kLoadAcceleration | kLoadPwm | kStart, little(kOne / 64, 4) + Bytes{60});
    rig->wait(milliseconds(500));
    load(kLoadAcceleration | kLoadPwm, little(kOne, 4) + Bytes{60});  // waits for Start Motion
    stop(kAmplifier | kSmoothly);
    const double v = number("command_velocity");
    EXPECT_GT(v, 10);
    rig->waitTicks(64);
    EXPECT_EQ(number("command_velocity"), v - 1);
    rig->waitTicks(static_cast<int>(64 * v));
    EXPECT_EQ(number("command_velocity"), 0);
    EXPECT_EQ(truth("servo_on"), true);
    expectNoViolation();
}

TEST_P(PicServo, IoControl1_Bit0IsTheOutputValueOfLimit1) {
    command(0x18, {0x01});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit1);
    command(0x18, {0x00});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), 0U);
    expectNoViolation();
}

TEST_P(PicServo, IoControl2_Bit1IsTheOutputValueOfLimit2) {
    command(0x18, {0x02});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit2);
    command(0x18, {0x00});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), 0U);
}

TEST_P(PicServo, IoControl3_Bit2IsTheDirectionOfLimit1) {
    rig->must("set 1 limit1 1");
    command(0x18, {0x04});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit1) << "an input";
    command(0x18, {0x08});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), 0U) << "an output, low";
}

TEST_P(PicServo, IoControl4_Bit3IsTheDirectionOfLimit2) {
    rig->must("set 1 limit2 1");
    command(0x18, {0x08});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit2) << "an input";
    command(0x18, {0x04});
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), 0U) << "an output, low";
}

TEST_P(PicServo, IoControl5_BothAreInputsByDefault) {
    rig->must("set 1 limit1 1");
    rig->must("set 1 limit2 1");
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit1 | kLimit2);
}

TEST_P(PicServo, IoControl6_Bits4To7AreToBeCleared) {
    command(0x18, {0x0C});
    expectNoViolation();
    command(0x18, {0x10});
    expectViolation("reserved_bits");
}

TEST_P(PicServo, SaveCurrentPositionAsHome1_SavesThePositionAsTheHomePosition) {
    turnAway();
    EXPECT_EQ(status().home, 0);
    command(0x0C);
    EXPECT_EQ(status().home, truth("position"));
    expectNoViolation();
}

TEST_P(PicServo, SaveCurrentPositionAsHome2_ToAGroupSavesAllPositionsAtOnce) {
    start("servo,servo", 2);
    for (const unsigned at : {1U, 2U}) {
        servoOn(kGoodGains, at);
        trapezoid(100'000, kOne, kOne, 0, at);
    }
    rig->command(0xFF, 0x05);
    rig->waitTicks(100);
    const int first = rig->state(1)["position"];
    const int second = rig->state(2)["position"];
    rig->command(0xFF, 0x0C);
    rig->waitTicks(100);
    // The packet has arrived 4 ticks later, at 1 count per tick.
    EXPECT_NEAR(status(1).home, first + 4, 3);
    EXPECT_NEAR(status(2).home, second + 4, 3);
    EXPECT_NEAR(status(1).home, status(2).home, 2) << "although they have been read one after the other";
    expectNoViolation();
}

}  // namespace
}  // namespace nmc::conformance
