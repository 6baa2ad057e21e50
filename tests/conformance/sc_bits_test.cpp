// SPDX-License-Identifier: GPL-3.0-or-later
// PIC-SERVO SC and CMC: I/O Control, voltage sense, status bits, step and direction, saved configuration.
#include "tests/conformance/scservo.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST_P(ScServo, SetBaudRate1_Divisor5Is230400) {
    rig->command(0xFF, 0x1A, {5});
    rig->setBaud(230'400);
    EXPECT_EQ(command(0x13, {0x20}), (Bytes{0x19, 0, 10, 0x23}));
    EXPECT_EQ(truth("baud"), 227'273) << "40 MHz / 16 / 11";
    expectNoViolation();
}

// ---- I/O Control ----

TEST_P(ScServo, IoControl1_Bits0And1AreUnused) {
    ioControl(0x03);
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), 0U) << "no limit pin becomes an output";
    rig->must("set 1 limit1 1");
    EXPECT_EQ(status().byte & (kLimit1 | kLimit2), kLimit1);
}

TEST_P(ScServo, IoControl2_ALimitSwitchesTheMotorOff) {
    ioControl(kLimitOff);
    runForward();
    ASSERT_EQ(truth("servo_on"), true);
    rig->must("set 1 limit1 1");
    rig->waitTicks(2);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(ScServo, IoControl3_ALimitStopsTheMotorAbruptly) {
    ioControl(kLimitAbrupt);
    runForward();
    rig->must("set 1 limit1 1");
    rig->waitTicks(2);
    EXPECT_EQ(truth("servo_on"), true);
    EXPECT_EQ(truth("command_velocity"), 0.0);
}

TEST_P(ScServo, IoControl4_Limit1StopsForwardAndLimit2ReverseMotion) {
    ioControl(kLimitAbrupt);
    runForward();
    rig->must("set 1 limit2 1");
    rig->wait(milliseconds(50));
    EXPECT_EQ(truth("command_velocity"), 5.0);
    rig->must("set 1 limit2 0");
    runForward(-5);
    rig->must("set 1 limit1 1");
    rig->wait(milliseconds(50));
    EXPECT_EQ(truth("command_velocity"), -5.0);
    rig->must("set 1 limit2 1");
    rig->waitTicks(2);
    EXPECT_EQ(truth("command_velocity"), 0.0);
}

TEST_P(ScServo, IoControl5_AMotionIntoAClosedLimitIsRefused) {
    servoOn();
    ioControl(kLimitAbrupt);
    rig->must("set 1 limit1 1");
    trapezoid(1000, 5 * kOne, kOne);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_position"), 0.0);
    velocity(static_cast<std::int32_t>(kOne), kOne);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_position"), 0.0);
    trapezoid(-1000, 5 * kOne, kOne);
    rig->wait(seconds(1));
    EXPECT_EQ(truth("command_position"), -1000.0) << "it moves away from the limit";
    // A refused motion does not switch the motor off.
    ioControl(kLimitOff);
    trapezoid(1000, 5 * kOne, kOne);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_position"), -1000.0);
    EXPECT_EQ(truth("servo_on"), true);
}

TEST_P(ScServo, IoControl6_SoIsPwmIntoAClosedLimit) {
    stop(kAmplifier);
    ioControl(kLimitAbrupt);
    rig->must("set 1 limit2 1");
    pwm(-40);
    EXPECT_EQ(truth("pwm"), 0);
    pwm(40);
    EXPECT_EQ(truth("pwm"), 40);
    rig->must("set 1 limit1 1");
    rig->waitTicks(2);
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(ScServo, IoControl7_BothLimitsClosedStopEverything) {
    for (const std::int32_t speed : {5, -5}) {
        rig->must("set 1 limit1 0");
        rig->must("set 1 limit2 0");
        ioControl(kLimitAbrupt);
        runForward(speed);
        ASSERT_EQ(truth("command_velocity"), static_cast<double>(speed));
        rig->must("set 1 limit1 1");
        rig->must("set 1 limit2 1");
        rig->waitTicks(2);
        EXPECT_EQ(truth("command_velocity"), 0.0);
    }
}

TEST_P(ScServo, IoControl8_Bit4IsThreePhase) {
    ioControl(kThreePhase);
    EXPECT_EQ(truth("three_phase"), true);
    EXPECT_EQ(truth("antiphase"), false);
}

TEST_P(ScServo, IoControl9_Bit5IsAntiphase) {
    ioControl(kAntiphase);
    EXPECT_EQ(truth("antiphase"), true);
    EXPECT_EQ(truth("three_phase"), false);
}

TEST_P(ScServo, IoControl10_Bit6IsTheFastPath) {
    ioControl(kFastPath);
    EXPECT_EQ(truth("fast_path"), true);
    start("servo@5", 1);
    ioControl(0x0C | kFastPath);
    EXPECT_EQ(truth("fast_path"), true);
}

TEST_P(ScServo, IoControl11_Bit7IsStepAndDirectionAndWantsNoLimitStop) {
    ioControl(kStepAndDirection | kThreePhase);
    EXPECT_EQ(truth("step_and_direction"), true);
    expectNoViolation();
    ioControl(kStepAndDirection | kLimitAbrupt);
    expectViolation("out_of_range");
}

TEST_P(ScServo, IoControl12_EachCommandAppliesEveryBit) {
    ioControl(kThreePhase | kFastPath | kLimitOff);
    ioControl(kAntiphase);
    EXPECT_EQ(truth("three_phase"), false);
    EXPECT_EQ(truth("fast_path"), false);
    EXPECT_EQ(truth("limit_stop"), "none");
    EXPECT_EQ(truth("antiphase"), true);
}

TEST_P(ScServo, IoControl13_WithoutItLimitsDoNotStopTheMotor) {
    runForward();
    rig->must("set 1 limit1 1");
    rig->must("set 1 limit2 1");
    rig->wait(milliseconds(50));
    EXPECT_EQ(truth("command_velocity"), 5.0);
}

// ---- Voltage sense ----

TEST_P(ScServo, VoltageSense1_PowerIsGoodFrom0Point9To4Point5Volts) {
    const auto isOn = [this](const char* volts) {
        rig->must(std::string("set 1 vsense ") + volts);
        rig->waitTicks(2);
        return (status().byte & kPowerOn) != 0;
    };
    EXPECT_FALSE(isOn("0.89"));
    EXPECT_TRUE(isOn("0.91"));
    EXPECT_TRUE(isOn("4.49"));
    EXPECT_FALSE(isOn("4.51"));
}

TEST_P(ScServo, VoltageSense2_TooLittleSwitchesTheServoOffAndLowersTheEnables) {
    servoOn();
    rig->must("set 1 vsense 0.5");
    rig->waitTicks(2);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("amp_enabled"), false);
}

TEST_P(ScServo, VoltageSense3_TheEnablesReturnByThemselvesAndTheServoDoesNot) {
    servoOn();
    rig->must("set 1 vsense 0.5");
    rig->wait(milliseconds(10));
    rig->must("set 1 vsense 3");
    rig->wait(milliseconds(10));
    EXPECT_EQ(truth("amp_enabled"), true);
    EXPECT_EQ(truth("servo_on"), false);
}

TEST_P(ScServo, VoltageSense4_TooMuchLowersTheEnablesOnlyWhileItLasts) {
    servoOn();
    rig->must("set 1 vsense 4.8");
    rig->wait(milliseconds(10));
    EXPECT_EQ(truth("amp_enabled"), false);
    EXPECT_EQ(truth("servo_on"), true);
    rig->must("set 1 vsense 4.4");
    rig->wait(milliseconds(10));
    EXPECT_EQ(truth("amp_enabled"), true);
    EXPECT_EQ(truth("servo_on"), true);
}

TEST_P(ScServo, VoltageSense5_TooLittleSetsThePwmValueTo0) {
    pwm(60);
    EXPECT_EQ(truth("pwm"), 60);
    rig->must("set 1 vsense 0.5");
    rig->waitTicks(2);
    EXPECT_EQ(truth("pwm"), 0);
    pwm(60);
    rig->waitTicks(2);
    EXPECT_EQ(truth("pwm"), 0) << "started without power";
    rig->must("set 1 vsense 3");
    rig->wait(milliseconds(10));
    EXPECT_EQ(truth("pwm"), 0);
}

// ---- Auxiliary status byte ----

TEST_P(ScServo, ScAuxByte0_TheIndexIsNotComplemented) {
    EXPECT_EQ(auxiliary() & 0x01U, 1U);
    rig->must("set 1 index 0");
    EXPECT_EQ(auxiliary() & 0x01U, 0U);
    start("servo@5", 1);
    EXPECT_EQ(auxiliary() & 0x01U, 0U) << "a CMC has the complement";
}

TEST_P(ScServo, ScAuxByte1_PositionWrap) {
    command(0x50, Bytes{0x02} + position(0x7FFF'FFF0));
    servoOn();
    EXPECT_EQ(auxiliary() & kPositionWrap, 0U);
    velocity(5 * static_cast<std::int32_t>(kOne), kOne);
    rig->wait(milliseconds(200));
    EXPECT_LT(number("position"), 0);
    EXPECT_EQ(auxiliary() & kPositionWrap, kPositionWrap);
}

TEST_P(ScServo, ScAuxByte2_ServoOn) {
    EXPECT_EQ(auxiliary() & kServoOn, 0U);
    servoOn();
    EXPECT_EQ(auxiliary() & kServoOn, kServoOn);
}

TEST_P(ScServo, ScAuxByte3_AccelIsSetWhileTheSpeedGrows) {
    servoOn();
    // By 10 / 65536 per tick it takes 65 536 ticks, half a minute.
    velocity(10 * static_cast<std::int32_t>(kOne), 10);
    EXPECT_EQ(auxiliary() & 0x18U, 0x08U);
    stop(kAmplifier | kSmoothly);
    EXPECT_EQ(auxiliary() & 0x08U, 0U) << "decelerating, or at rest";
}

TEST_P(ScServo, ScAuxByte4_SlewIsSetAtConstantSpeedOrAtRest) {
    EXPECT_EQ(auxiliary() & 0x10U, 0x10U);
    runForward();
    EXPECT_EQ(auxiliary() & 0x18U, 0x10U);
}

TEST_P(ScServo, ScAuxByte5_ServoOverrun) {
    EXPECT_EQ(auxiliary() & kServoOverrun, 0U);
    rig->must("set 1 servo_overrun 1");
    EXPECT_EQ(auxiliary() & kServoOverrun, kServoOverrun);
}

TEST_P(ScServo, ScAuxByte6_PathMode) {
    EXPECT_EQ(auxiliary() & 0x40U, 0U);
    servoOn();
    points({0x0102, 0x0102, 0x0102, 0x0102});
    command(0x0D);
    EXPECT_EQ(auxiliary() & 0x40U, 0x40U);
    rig->wait(seconds(1));
    EXPECT_EQ(auxiliary() & 0x40U, 0U);
}

TEST_P(ScServo, ClearBits1_ClearsOvercurrentPositionErrorWrapAndOverrun) {
    servoOn({.kp = 200, .kd = 2000, .cl = 51});
    rig->must("set 1 analog 60");
    rig->must("set 1 servo_overrun 1");
    rig->waitTicks(2);
    rig->must("set 1 analog 0");
    rig->must("set 1 vsense 0");
    rig->waitTicks(2);
    rig->must("set 1 vsense 3");
    stop(kAmplifier | kAbruptly);
    ASSERT_EQ(status().byte & (kOvercurrent | kPositionError), kOvercurrent | kPositionError);
    ASSERT_EQ(auxiliary() & kServoOverrun, kServoOverrun);
    command(0x0B);
    EXPECT_EQ(status().byte & (kOvercurrent | kPositionError), 0U);
    EXPECT_EQ(auxiliary() & (kServoOverrun | kPositionWrap), 0U);
}

// ---- Step and direction ----

TEST_P(ScServo, StepAndDirection1_StepsTimesTheMultiplierMoveTheCommand) {
    servoOn();
    command(0xF6, gainBytes(kGoodGains) + Bytes{5});
    ioControl(kStepAndDirection);
    rig->must("set 1 steps 100");
    rig->waitTicks(2);
    EXPECT_EQ(truth("command_position"), 500.0);
    rig->must("set 1 steps -20");
    rig->wait(milliseconds(500));
    EXPECT_EQ(truth("command_position"), 400.0);
    EXPECT_NEAR(number("position"), 400, 3);
}

TEST_P(ScServo, StepAndDirection2_WithoutTheModeStepsAreNotHeard) {
    servoOn();
    rig->must("set 1 steps 100");
    rig->wait(milliseconds(10));
    EXPECT_EQ(truth("command_position"), 0.0);
}

TEST_P(ScServo, StepAndDirection3_AServoFaultRaisesAddrOut) {
    start("servo@10,servo", 2, {"--deaf-when-addr-in-rises"});
    servoOn();
    ioControl(kStepAndDirection);
    ASSERT_EQ(command(0x0E, {}, 2).size(), 2U);
    rig->must("set 1 vsense 0");
    rig->wait(milliseconds(200));
    EXPECT_EQ(command(0x0E, {}, 2).size(), 0U) << "its ADDR_IN is high";
    rig->must("set 1 vsense 3");
    stop(kAmplifier | kAbruptly);
    EXPECT_EQ(command(0x0E, {}, 2).size(), 2U);
}

// ---- Hard Reset and saved configuration ----

TEST_P(ScServo, HardReset1_IsObeyedByAnyGroupWhenItIsForAll) {
    command(0x21, {1, 0x85});
    turnAway();
    rig->command(0xFF, 0x0F);
    EXPECT_EQ(truth("address"), 0);
    EXPECT_EQ(truth("position"), 0);
}

TEST_P(ScServo, HardReset2_SavesVelocityAccelerationAndGainsOverAPowerCycle) {
    command(0xF6, gainBytes({.kp = 200, .kd = 2000, .ki = 20, .il = 200, .sr = 1}) + Bytes{7});
    load(kServo | kLoadVelocity | kLoadAcceleration, little(3 * kOne, 4) + little(kOne, 4));
    command(0x1F, {kSave});
    powerCycle();
    EXPECT_EQ(truth("gains")["kp"], 200);
    EXPECT_EQ(truth("step_multiplier"), 7);
    EXPECT_EQ(truth("saved"), kSave);
    rig->address(1);
    stop(kAmplifier | kAbruptly);
    load(kServo | kVelocityProfile | kStart);
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("command_velocity"), 3.0) << "neither velocity nor acceleration was loaded again";
}

TEST_P(ScServo, HardReset3_ItselfRestoresNothing) {
    gains(kGoodGains);
    command(0x1F, {kSave | kSaveAddresses | kSaveAmplifier | kSaveServo});
    rig->wait(milliseconds(20));
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(truth("gains")["kp"], 0);
        EXPECT_EQ(truth("address"), 0);
        EXPECT_EQ(truth("servo_on"), false);
        EXPECT_EQ(truth("amp_enabled"), false);
        rig->command(0xFF, 0x0F);
        rig->wait(milliseconds(20));
    }
    EXPECT_EQ(truth("saved"), kSave | kSaveAddresses | kSaveAmplifier | kSaveServo);
}

TEST_P(ScServo, HardReset4_ButThreePhaseAndAntiphaseSurviveIt) {
    command(0x1F, {kSave | kSaveThreePhase | kSaveAntiphase | kSaveSteps});
    rig->wait(milliseconds(20));
    EXPECT_EQ(truth("three_phase"), true);
    EXPECT_EQ(truth("antiphase"), true);
    EXPECT_EQ(truth("step_and_direction"), false);
    rig->command(0xFF, 0x0F);
    rig->wait(milliseconds(20));
    EXPECT_EQ(truth("three_phase"), true);
    EXPECT_EQ(truth("antiphase"), true);
}

TEST_P(ScServo, HardReset5_Bit1RestoresTheAddresses) {
    start("servo@10,servo", 0);
    command(0x21, {7, 0x05}, 0);
    command(0x1F, {kSave | kSaveAddresses}, 7);
    powerCycle();
    EXPECT_EQ(truth("address"), 7);
    EXPECT_EQ(truth("group"), 0x85);
    EXPECT_EQ(truth("leader"), true);
    EXPECT_EQ(command(0x0E, {}, 7).size(), 2U);
    EXPECT_EQ(command(0x21, {2, 0xFF}, 0).size(), 2U) << "the next module listens";
}

TEST_P(ScServo, HardReset6_Bits2And3SwitchAmplifierAndServoOn) {
    gains(kGoodGains);
    command(0x1F, {kSave | kSaveAddresses | kSaveAmplifier | kSaveServo});
    powerCycle();
    EXPECT_EQ(truth("amp_enabled"), true);
    EXPECT_EQ(truth("servo_on"), true);
    EXPECT_EQ(truth("command_position"), 0.0);
}

TEST_P(ScServo, HardReset7_WithoutBit1TheyWaitForAnAddress) {
    gains(kGoodGains);
    command(0x1F, {kSave | kSaveAmplifier | kSaveServo});
    powerCycle();
    EXPECT_EQ(truth("amp_enabled"), false);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("address"), 0);
    rig->address(1);
    EXPECT_EQ(truth("amp_enabled"), true);
    EXPECT_EQ(truth("servo_on"), true);
}

TEST_P(ScServo, HardReset8_Bits4And5RestoreStepAndDirectionAndLimitProtection) {
    command(0x1F, {kSave | kSaveSteps});
    powerCycle();
    EXPECT_EQ(truth("step_and_direction"), true);
    EXPECT_EQ(truth("limit_stop"), "none");
    rig->address(1);
    command(0x1F, {kSave | kSaveLimits});
    powerCycle();
    EXPECT_EQ(truth("step_and_direction"), false);
    EXPECT_EQ(truth("limit_stop"), "abrupt");
}

TEST_P(ScServo, HardReset9_WithBit0ClearItErases) {
    gains(kGoodGains);
    command(0x1F, {kSave | kSaveAddresses});
    powerCycle();
    ASSERT_EQ(truth("address"), 1);
    command(0x1F, {0x00});
    powerCycle();
    EXPECT_EQ(truth("saved"), nullptr);
    EXPECT_EQ(truth("address"), 0);
    EXPECT_EQ(truth("gains")["kp"], 0);
}

TEST_P(ScServo, HardReset10_OlderChipsIgnoreTheByte) {
    for (const char* chip : {"servo@4", "servo@5"}) {
        start(chip, 1);
        gains(kGoodGains);
        command(0x1F, {kSave | kSaveAddresses});
        EXPECT_EQ(truth("address"), 0) << chip;
        powerCycle();
        EXPECT_EQ(truth("address"), 0) << chip;
        EXPECT_EQ(truth("gains")["kp"], 0) << chip;
        expectNoViolation();
    }
}

}  // namespace
}  // namespace nmc::conformance
