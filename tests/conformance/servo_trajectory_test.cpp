// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2: Load Trajectory, Start Motion; 5.1, "While Moving?", for both; 4.4.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

TEST_P(PicServo, LoadTrajectory1_Bit0LoadsThePositionAsTheGoal) {
    servoOn();
    trapezoid(300, 4 * kOne, kOne);
    rig->waitTicks(200);
    EXPECT_EQ(number("command_position"), 300);
    // Parameters that are not loaded again stay as they were.
    load(kServo | kLoadPosition | kStart, position(-0x102));
    rig->waitTicks(300);
    EXPECT_EQ(number("command_position"), -0x102);
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory2_Bit1LoadsTheVelocityIn65536thsOfACountPerTick) {
    servoOn();
    velocity(5 * kOne / 2, kOne);
    EXPECT_EQ(number("command_velocity"), 2.5);
    const double before = number("command_position");
    rig->waitTicks(100);
    EXPECT_EQ(number("command_position") - before, 250);
}

TEST_P(PicServo, LoadTrajectory3_Bit2LoadsTheAccelerationIn65536thsOfACountPerTickSquared) {
    servoOn();
    velocity(100 * kOne, kOne / 64);
    const double before = number("command_velocity");
    rig->waitTicks(64);
    EXPECT_EQ(number("command_velocity") - before, 1);
}

TEST_P(PicServo, LoadTrajectory4_Bit3LoadsThePwmValue) {
    load(kLoadPwm | kStart, {77});
    EXPECT_EQ(truth("pwm"), 77);
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory5_Bit4SaysWhetherThePositionServoIsUsed) {
    gains(kGoodGains);
    load(kServo | kVelocityProfile | kStart);
    EXPECT_EQ(truth("servo_on"), true);
    load(kStart);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("mode"), "pwm");
}

TEST_P(PicServo, LoadTrajectory6_Bit5SaysTrapezoidalOrVelocityProfile) {
    servoOn();
    trapezoid(100, kOne, kOne);
    EXPECT_EQ(truth("mode"), "trapezoidal");
    rig->waitTicks(200);
    EXPECT_EQ(number("command_position"), 100) << "it ends at its goal";
    velocity(kOne, kOne);
    EXPECT_EQ(truth("mode"), "velocity");
    rig->waitTicks(200);
    EXPECT_GT(number("command_position"), 300) << "it continues";
}

TEST_P(PicServo, LoadTrajectory7_Bit6ReversesInVelocityMode) {
    servoOn();
    velocity(-2 * std::int32_t{kOne}, kOne);
    rig->waitTicks(200);
    EXPECT_EQ(number("command_velocity"), -2);
    EXPECT_LT(number("shaft"), -300);
}

TEST_P(PicServo, LoadTrajectory8_Bit6ReversesInPwmMode) {
    stop(kAmplifier);
    load(kLoadPwm | kReverse | kStart, {77});
    EXPECT_EQ(truth("pwm"), -77);
    rig->waitTicks(200);
    EXPECT_LT(number("shaft"), -300);
}

TEST_P(PicServo, LoadTrajectory9_Bit7ExecutesTheCommandAtOnce) {
    servoOn();
    rig->send(packet(1, 0x94,
                     Bytes{kServo | kVelocityProfile | 0x06 | kStart} + little(kOne, 4) + little(kOne, 4)));
    // 13 bytes of 10 bits at 19 200 Bd; the command is executed at the end of the tick, so that the motion
    // begins in the next one.
    rig->wait(std::chrono::microseconds(6'771) + 2 * kTick);
    EXPECT_EQ(number("command_velocity"), 1);
}

TEST_P(PicServo, LoadTrajectory10_WithoutBit7TheDataWaitsForStartMotion) {
    servoOn();
    trapezoid(100, kOne, kOne, 0);
    rig->waitTicks(200);
    EXPECT_EQ(number("command_position"), 0);
    EXPECT_EQ(truth("mode"), "velocity");
    command(0x05);
    rig->waitTicks(200);
    EXPECT_EQ(number("command_position"), 100);
}

TEST_P(PicServo, LoadTrajectory11_DataComeInTheOrderListedLeastSignificantByteFirst) {
    servoOn();
    load(kServo | kLoadVelocity, little(2 * kOne, 4));
    // The sheet's example: position and acceleration, no start. 3 E8 is 1000, 0 80 00 half a count per tick².
    command(0x94, {0x15, 0xE8, 0x03, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00});
    rig->waitTicks(10);
    EXPECT_EQ(number("command_position"), 0);
    command(0x05);
    EXPECT_EQ(number("command_velocity"), 2);
    rig->wait(milliseconds(400));
    EXPECT_EQ(number("command_position"), 1000);
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory12_TakesOneToFourteenDataBytes) {
    // All four values, in their order: the PWM value is the last.
    EXPECT_EQ(command(0xE4, Bytes{0x0F} + position(7) + little(kOne, 4) + little(kOne, 4) + Bytes{33}).size(),
              2U);
    EXPECT_EQ(truth("pwm"), 0);
    EXPECT_EQ(command(0x14, {kStart}).size(), 2U);
    EXPECT_EQ(truth("pwm"), 33);
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory13_EachOfBits0To3RequiresItsData) {
    command(0x14, {kLoadVelocity | kServo});
    expectViolation("wrong_length");
}

TEST_P(PicServo, LoadTrajectory14_ThePositionIsUsedInTrapezoidalModeOnly) {
    servoOn();
    load(kServo | kVelocityProfile | 0x07 | kStart, position(50) + little(kOne, 4) + little(kOne, 4));
    rig->waitTicks(100);
    EXPECT_GT(number("command_position"), 100);
}

TEST_P(PicServo, LoadTrajectory15_InTrapezoidalModeTheVelocityIsTheMaximum) {
    servoOn();
    trapezoid(2000, 4 * kOne, kOne / 16);
    double fastest = 0;
    for (int i = 0; i < 300; ++i) {
        fastest = std::max(fastest, number("command_velocity"));
        rig->waitTicks(1);
    }
    EXPECT_EQ(fastest, 4);
}

TEST_P(PicServo, LoadTrajectory16_TheAccelerationIsUsedInTrapezoidalModeToo) {
    servoOn();
    trapezoid(100'000, 100 * kOne, kOne / 64);
    const double before = number("command_velocity");
    rig->waitTicks(64);
    EXPECT_EQ(number("command_velocity") - before, 1);
}

TEST_P(PicServo, LoadTrajectory17_ATrapezoidTakesDistanceOverVelocityPlusVelocityOverAcceleration) {
    servoOn();
    rig->send(packet(1, 0xD4, Bytes{0x97} + position(2000) + little(4 * kOne, 4) + little(kOne / 16, 4)));
    while (number("command_position") == 0)
        rig->waitTicks(1);
    int ticks = 1;
    for (; number("command_position") != 2000 && ticks < 1000; ++ticks)
        rig->waitTicks(1);
    EXPECT_NEAR(ticks, 2000 / 4 + 4 * 16, 2);
}

TEST_P(PicServo, LoadTrajectory18_AShortTrapezoidIsATriangle) {
    servoOn();
    rig->send(packet(1, 0xD4, Bytes{0x97} + position(100) + little(4 * kOne, 4) + little(kOne / 16, 4)));
    double fastest = 0;
    for (int i = 0; i < 120; ++i) {
        rig->waitTicks(1);
        fastest = std::max(fastest, number("command_velocity"));
    }
    EXPECT_NEAR(fastest, 2.5, 1.0 / 16) << "the root of 100 / 16";
    EXPECT_EQ(number("command_position"), 100);
}

TEST_P(PicServo, LoadTrajectory19_ThePwmValueIsUsedOnlyWhileTheServoDoesNotOperate) {
    servoOn({});
    load(kServo | kVelocityProfile | kLoadPwm | kStart, {99});
    rig->waitTicks(10);
    EXPECT_EQ(truth("pwm"), 0) << "with all gains zero";
}

TEST_P(PicServo, LoadTrajectory20_ThePwmValueBecomesZeroWhenTheServoIsDisabledAutomatically) {
    servoOn({.el = 50});
    load(kLoadPwm, {99});
    stopHere(51);
    EXPECT_EQ(truth("servo_on"), false) << "an excess position error";
    load(kStart);
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(PicServo, LoadTrajectory21_VelocityAndAccelerationAreAtMost7FFFFFFF) {
    velocity(0x7FFF'FFFF, 0x7FFF'FFFF, 0);
    expectNoViolation();
    load(kServo | kLoadVelocity, little(0x8000'0000, 4));
    load(kServo | kLoadAcceleration, little(0x8000'0000, 4));
    EXPECT_EQ(rig->violations(), (std::vector<std::string>{"out_of_range", "out_of_range"}));
}

TEST_P(PicServo, LoadTrajectory22_ATrapezoidStartsFromStandstillOnly) {
    servoOn();
    velocity(kOne, kOne);
    trapezoid(1000, kOne, kOne);
    expectViolation("trapezoid_in_motion");
}

TEST_P(PicServo, LoadTrajectory23_Bit0OfTheStatusByteTellsWhenTheTrapezoidIsComplete) {
    servoOn();
    trapezoid(1000, 4 * kOne, kOne);  // 254 ticks
    EXPECT_EQ(status().byte & kMoveDone, 0U);
    rig->waitTicks(100);
    EXPECT_EQ(status().byte & kMoveDone, 0U);
    rig->waitTicks(100);
    EXPECT_EQ(status().byte & kMoveDone, kMoveDone);
}

TEST_P(PicServo, LoadTrajectory24_Bit0OfTheStatusByteTellsWhenTheVelocityIsReached) {
    servoOn();
    velocity(2 * kOne, kOne / 64);  // 128 ticks
    EXPECT_EQ(status().byte & kMoveDone, 0U);
    rig->waitTicks(128);
    EXPECT_EQ(status().byte & kMoveDone, kMoveDone);
}

TEST_P(PicServo, LoadTrajectory25_InVelocityModeVelocityAndAccelerationMayChangeAtAnyTime) {
    servoOn();
    velocity(2 * kOne, kOne);
    velocity(4 * kOne, kOne / 64);
    const double before = number("command_velocity");
    EXPECT_LT(before, 4);
    rig->waitTicks(16);
    EXPECT_EQ(number("command_velocity") - before, 0.25);
    velocity(kOne, kOne / 32);
    rig->waitTicks(200);
    EXPECT_EQ(number("command_velocity"), 1) << "it slows down if it is too fast";
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory26_VelocityModeMayBeEnteredInTheMiddleOfATrapezoid) {
    servoOn();
    trapezoid(10'000, 2 * kOne, kOne);
    rig->waitTicks(50);
    velocity(3 * kOne, kOne / 64);
    EXPECT_GE(number("command_velocity"), 2);
    rig->waitTicks(100);
    EXPECT_EQ(number("command_velocity"), 3);
    expectNoViolation();
}

TEST_P(PicServo, LoadTrajectory27_WhileMovingATrapezoidMayBeLoadedButNotStarted) {
    servoOn();
    trapezoid(400, kOne, kOne);
    trapezoid(-400, 4 * kOne, kOne / 2, 0);
    expectNoViolation();
    rig->waitTicks(500);
    EXPECT_EQ(number("command_position"), 400) << "the running move continues";
    trapezoid(0, kOne, kOne);
    trapezoid(800, kOne, kOne);
    expectViolation("trapezoid_in_motion");
}

TEST_P(PicServo, StartMotion1_ExecutesTheTrajectoryLoadedLast) {
    servoOn();
    trapezoid(300, kOne, kOne, 0);
    trapezoid(100, kOne, kOne, 0);
    command(0x05);
    rig->waitTicks(400);
    EXPECT_EQ(number("command_position"), 100);
    expectNoViolation();
}

TEST_P(PicServo, StartMotion2_ToAGroupStartsAllItsModulesAtOnce) {
    start("servo,servo", 2);
    for (const unsigned at : {1U, 2U}) {
        servoOn(kGoodGains, at);
        trapezoid(300, kOne, kOne / 64, 0, at);
    }
    rig->command(0xFF, 0x05);
    rig->waitTicks(30);
    const double first = rig->state(1)["command_velocity"];
    const double second = rig->state(2)["command_velocity"];
    EXPECT_GT(first, 0.4);
    EXPECT_NEAR(first, second, 1.0 / 64) << "their ticks are not in step";
}

TEST_P(PicServo, StartMotion3_WhileMovingOnlyForATrajectoryInVelocityMode) {
    servoOn();
    trapezoid(10'000, kOne, kOne);
    velocity(2 * kOne, kOne, 0);
    command(0x05);
    expectNoViolation();
    trapezoid(10'000, kOne, kOne, 0);
    command(0x05);
    expectViolation("trapezoid_in_motion");
}

}  // namespace
}  // namespace nmc::conformance
