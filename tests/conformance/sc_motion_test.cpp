// SPDX-License-Identifier: GPL-3.0-or-later
// PIC-SERVO SC and CMC: Reset Position, Load Trajectory, Stop Motor, Set Gain, items 6 and 7.
#include "tests/conformance/scservo.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// ---- Reset Position ----

TEST_P(ScServo, ResetPosition1_WithoutDataBothPositionsBecomeZero) {
    turnAway();
    command(0x00);
    EXPECT_EQ(truth("position"), 0);
    EXPECT_EQ(truth("command_position"), 0.0);
}

TEST_P(ScServo, ResetPosition2_RelativeToHomeTakesTheHomePositionOff) {
    servoOn();
    trapezoid(400, 5 * kOne, kOne);
    rig->wait(seconds(1));
    command(0x0C);
    const int home = truth("home");
    trapezoid(1000, 5 * kOne, kOne);
    rig->wait(seconds(1));
    const int before = truth("position");
    command(0x10, {0x01});
    EXPECT_EQ(truth("position"), before - home);
    EXPECT_EQ(truth("command_position"), 1000.0 - home);
    rig->wait(seconds(1));
    EXPECT_NEAR(number("position"), 1000 - home, 2) << "nothing moves";
}

TEST_P(ScServo, ResetPosition3_SetsAnyPositionAndTheCommandFollows) {
    servoOn();
    command(0x50, {0x02, 0xA2, 0x32, 0x54, 0x01});
    EXPECT_NEAR(number("position"), 0x015432A2, 1);
    EXPECT_EQ(truth("command_position"), static_cast<double>(0x015432A2));
    stop(kAmplifier | kMotorOff);
    command(0x50, Bytes{0x02} + position(-70'000));
    EXPECT_EQ(truth("position"), -70'000);
}

TEST_P(ScServo, ResetPosition4_TakesOneOfItsTwoBitsOnly) {
    command(0x50, Bytes{0x02} + position(5));
    command(0x10, {0x01});
    expectNoViolation();
    command(0x50, Bytes{0x03} + position(5));
    expectViolation("out_of_range");
}

TEST_P(ScServo, ResetPosition5_LeavesTheHomePositionAlone) {
    turnAway();
    command(0x0C);
    const int home = truth("home");
    command(0x10, {0x01});
    EXPECT_EQ(truth("home"), home);
    command(0x50, Bytes{0x02} + position(9));
    EXPECT_EQ(truth("home"), home);
}

TEST_P(ScServo, ResetPosition6_ACmcKnowsTheFirstBitOnly) {
    start("servo@5", 1);
    turnAway();
    command(0x0C);
    command(0x10, {0x01});
    EXPECT_EQ(truth("position"), 0) << "position - home";
    command(0x50, Bytes{0x02} + position(77));
    EXPECT_EQ(truth("position"), 0);
}

TEST_P(ScServo, ResetPosition7_IsTakenDuringATrapezoidalMove) {
    servoOn();
    trapezoid(1000, kOne, kOne);
    command(0x00);
    expectNoViolation();
}

// ---- Load Trajectory ----

TEST_P(ScServo, LoadTrajectory1_Bit6IsReverseInVelocityAndPwmMode) {
    servoOn();
    velocity(-5 * static_cast<std::int32_t>(kOne), kOne);
    rig->wait(milliseconds(100));
    EXPECT_LT(number("command_velocity"), 0);
    pwm(-40);
    EXPECT_EQ(truth("pwm"), -40);
}

TEST_P(ScServo, LoadTrajectory2_Bit6InTrapezoidalModeIsRelativeToTheCommandPosition) {
    leanOnAnError();
    const double command = number("command_position");
    ASSERT_NE(number("position"), command);
    trapezoid(-300, 5 * kOne, kOne, kStart | kReverse);
    rig->wait(seconds(1));
    EXPECT_EQ(number("command_position"), command - 300);
    load(kServo | kLoadPosition | kStart | kReverse, position(1000));
    rig->wait(seconds(1));
    EXPECT_EQ(number("command_position"), command + 700);
    expectNoViolation();
}

TEST_P(ScServo, LoadTrajectory3_OlderChipsIgnoreItThere) {
    start("servo@4", 1);
    servoOn();
    trapezoid(500, 5 * kOne, kOne);
    rig->wait(seconds(1));
    trapezoid(200, 5 * kOne, kOne, kStart | kReverse);
    rig->wait(seconds(1));
    EXPECT_EQ(truth("command_position"), 200.0);
}

TEST_P(ScServo, LoadTrajectory4_TheGreatestVelocityIs83886080) {
    load(kServo | kVelocityProfile | kLoadVelocity, little(83'886'080, 4));
    expectNoViolation();
    load(kServo | kVelocityProfile | kLoadVelocity, little(83'886'081, 4));
    expectViolation("out_of_range");
}

TEST_P(ScServo, LoadTrajectory5_WithoutBit7TheDataWaitAndTheNextLoadReplacesThem) {
    servoOn();
    trapezoid(500, 5 * kOne, kOne, 0);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_position"), 0.0);
    trapezoid(-500, 5 * kOne, kOne, 0);
    command(0x05);
    rig->wait(seconds(1));
    EXPECT_EQ(truth("command_position"), -500.0);
}

TEST_P(ScServo, LoadTrajectory6_WithoutServoBitAndPwmByteTheOutputIsKept) {
    stop(kAmplifier);
    pwm(-60);
    load(kLoadVelocity | kStart, little(kOne, 4));
    EXPECT_EQ(truth("pwm"), -60);
    load(kLoadPwm | kStart, {30});
    EXPECT_EQ(truth("pwm"), 30);
}

TEST_P(ScServo, LoadTrajectory7_AMoveMayBeChangedUnderWay) {
    servoOn();
    trapezoid(20'000, 5 * kOne, 1000);
    rig->wait(milliseconds(300));
    const double speed = number("command_velocity");
    ASSERT_GT(speed, 1);
    trapezoid(300, 5 * kOne, 1000);
    EXPECT_GT(number("command_velocity"), speed / 2) << "it continues from the velocity it had";
    rig->wait(seconds(3));
    EXPECT_EQ(truth("command_position"), 300.0);
    EXPECT_EQ(status().byte & kMoveDone, kMoveDone);
    expectNoViolation();
}

// ---- Status items ----

TEST_P(ScServo, DefineStatus1_Item6IsTheCommandPositionLessThePosition) {
    leanOnAnError();
    const Place p = place();
    EXPECT_EQ(p.error, static_cast<int>(number("command_position")) - p.position);
    rig->must("set 1 load -0.1");
    rig->wait(seconds(1));
    EXPECT_LT(place().error, -5);
}

TEST_P(ScServo, DefineStatus2_Item7IsTheNumberOfPointsInTheBuffer) {
    EXPECT_EQ(pathPoints(), 0U);
    points({8, 8, 8});
    EXPECT_EQ(pathPoints(), 3U);
    points({8, 8, 8, 8, 8, 8, 8});
    EXPECT_EQ(pathPoints(), 10U);
}

TEST_P(ScServo, DefineStatus3_AllItemsMakeNineteenBytesInTheirOrder) {
    rig->must("set 1 analog 79");
    points({8, 8});
    const Bytes answer = command(0x12, {0xFF});
    // Type 0, version 10; no error; two points.
    EXPECT_EQ(answer, (Bytes{0x19, 0, 0, 0, 0, 79, 0, 0, 0x11, 0, 0, 0, 0, 0, 10, 0, 0, 2, 0x85}));
    EXPECT_EQ(command(0x0E), answer) << "permanent";
}

TEST_P(ScServo, DefineStatus4_TheVelocityIsNotNegated) {
    for (const char* chip : {"servo@10", "servo@5"}) {
        start(chip, 1);
        stop(kAmplifier);
        pwm(60);
        rig->wait(milliseconds(300));
        // 23.7 counts per tick, as calculated in PicServoItems.
        EXPECT_NEAR(static_cast<std::int16_t>(wordAt(command(0x13, {0x04}), 1)), 23.7, 1) << chip;
    }
}

TEST_P(ScServo, DefineStatus5_PositionAndErrorMakeTheCommandPosition) {
    leanOnAnError();
    const Place p = place();
    EXPECT_EQ(p.position + p.error, truth("command_position"));
}

TEST_P(ScServo, DefineStatus6_ACmcHasBothItemsToo) {
    start("servo@5", 1);
    const Bytes answer = command(0x13, {0xE0});
    EXPECT_EQ(answer, (Bytes{0x19, 0, 5, 0, 0, 0, 0x1E}));
}

// ---- Stop Motor ----

TEST_P(ScServo, StopMotor1_Off) {
    runForward();
    stop(kMotorOff);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("pwm"), 0);
    EXPECT_EQ(truth("amp_enabled"), false);
}

TEST_P(ScServo, StopMotor2_Abruptly) {
    runForward();
    stop(kAmplifier | kAbruptly);
    EXPECT_EQ(truth("command_velocity"), 0.0);
    EXPECT_EQ(truth("servo_on"), true);
}

TEST_P(ScServo, StopMotor3_Smoothly) {
    servoOn();
    velocity(5 * static_cast<std::int32_t>(kOne), 1000);
    rig->wait(seconds(1));
    // From 5 counts per tick at 1000/65536 it takes 328 ticks, 168 ms.
    rig->exchange(packet(1, 0x17, {0x09}));
    rig->wait(milliseconds(100));
    EXPECT_GT(number("command_velocity"), 0.5);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_velocity"), 0.0);
}

TEST_P(ScServo, StopMotor4_Here) {
    servoOn();
    command(0x57, {0x11, 0x64, 0x00, 0x00, 0x00});
    EXPECT_EQ(truth("command_position"), 100.0);
    EXPECT_EQ(truth("mode"), "stop-here");
}

TEST_P(ScServo, StopMotor5_KeepsTheVelocityParameter) {
    runForward();
    stop(kAmplifier | kSmoothly);
    rig->wait(milliseconds(200));
    load(kServo | kVelocityProfile | kStart);
    rig->wait(milliseconds(200));
    EXPECT_EQ(truth("command_velocity"), 5.0);
}

TEST_P(ScServo, StopMotor6_AnScIgnoresBit5) {
    stop(0x21);
    EXPECT_EQ(truth("amp_enabled"), true);
    points({8});
    EXPECT_EQ(pathPoints(), 1U);
    expectNoViolation();
}

TEST_P(ScServo, StopMotor7_Bit5SwitchesOnTheAdvancedFeaturesOfACmc) {
    start("servo@5", 1);
    points({8});
    EXPECT_EQ(pathPoints(), 0U);
    expectViolation("unsupported");
    stop(kAmplifier | 0x20);
    points({8});
    EXPECT_EQ(pathPoints(), 1U);
    stop(kAmplifier);
    points({8});
    EXPECT_EQ(pathPoints(), 2U) << "they stay on";
}

// ---- Set Gain, PWM ----

TEST_P(ScServo, SetGain1_TheFifteenthByteIsTheStepMultiplier) {
    command(0xF6, {0x64, 0, 0xE8, 0x03, 0x32, 0, 0xC8, 0, 0xFF, 0x35, 0xA0, 0x0F, 1, 0, 5});
    EXPECT_EQ(truth("gains")["kp"], 100);
    EXPECT_EQ(truth("gains")["kd"], 1000);
    EXPECT_EQ(truth("gains")["ki"], 50);
    EXPECT_EQ(truth("gains")["il"], 200);
    EXPECT_EQ(truth("gains")["cl"], 0x35);
    EXPECT_EQ(truth("gains")["el"], 4000);
    EXPECT_EQ(truth("step_multiplier"), 5);
    expectNoViolation();
}

TEST_P(ScServo, SetGain2_WithoutItTheMultiplierIsOne) {
    gains(kGoodGains);
    EXPECT_EQ(truth("step_multiplier"), 1);
    EXPECT_EQ(truth("gains")["kp"], 200);
    expectNoViolation();
}

TEST_P(ScServo, Pwm1_TheOutputHasTwoMoreBits) {
    servoOn({.kp = 64});
    block();
    const int here = truth("position");
    // 64 x 3 / 256 is three quarters of a PWM count.
    stopHere(here + 3);
    rig->waitTicks(2);
    ASSERT_EQ(place().error, 3);
    EXPECT_EQ(truth("pwm_exact"), 0.75);
    start("servo@5", 1);
    servoOn({.kp = 64});
    block();
    stopHere(static_cast<std::int32_t>(number("position")) + 3);
    EXPECT_EQ(truth("pwm_exact"), 0.0);
}

}  // namespace
}  // namespace nmc::conformance
