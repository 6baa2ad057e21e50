// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1: Reset Position, Set Parameters, Stop Motor, Set Outputs.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

class PicStepCommands : public PicStep {
protected:
    /// Starts a velocity profile from 20 to 120 (3000 steps per second) with 1 ms for each speed, and waits
    /// until it is at its speed.
    void cruise() {
        parameters(k1x, 20);
        load({.speed = 120, .acceleration = 4});
        rig->wait(milliseconds(200));
        ASSERT_EQ(speed(), 120U);
    }
    void expectOutput(unsigned bit) {
        const auto outputs = [this] { return truth<unsigned>("outputs"); };
        command(0x18, {static_cast<std::uint8_t>(bit)});
        EXPECT_EQ(outputs(), bit);
        command(0x18, {static_cast<std::uint8_t>(~bit & 0x1FU)});
        EXPECT_EQ(outputs(), ~bit & 0x1FU);
        expectNoViolations();
    }
    /// Checks the steps per second at speed 40, which is also the minimum.
    void expectSpeedMode(unsigned mode, int stepsPerSecond, const Kinds& violations = {}) {
        parameters(mode, 40);
        load({.speed = 40, .acceleration = 1});
        EXPECT_NEAR(stepsIn(kEightSeconds), 8 * stepsPerSecond, 1);
        expectViolations(violations);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicStepCommands, kPlaces, nameOf);

TEST_P(PicStepCommands, ResetPosition1_IsCommand0WithoutData) {
    expectForm("reset_position", 0x00, {});
}

TEST_P(PicStepCommands, ResetPosition2_MakesThePositionCounter0) {
    parameters(k1x);
    moveTo(-1'234);
    EXPECT_EQ(command(0x00).size(), 2U);
    EXPECT_EQ(report().position, 0);
    expectNoViolations();
}

TEST_P(PicStepCommands, ResetPosition3_IsNotToBeIssuedInMotion) {
    parameters(k1x);
    run();
    command(0x00);
    expectViolations({"reset_in_motion"});
}

// ---- Set Parameters ----

TEST_P(PicStepCommands, SetParameters1_IsCommand6WithFiveBytes) {
    expectForm("set_parameters", 0x56, {k1x, 1, 0, 0, 0});
    command(0x46, {k1x, 1, 0, 0});
    expectViolations({"wrong_length", "wrong_length"});
}
TEST_P(PicStepCommands, SetParameters2_SpeedMode00Is8x) {
    expectSpeedMode(0, 8'000);
}
TEST_P(PicStepCommands, SetParameters3_SpeedMode01Is4x) {
    expectSpeedMode(1, 4'000);
}
TEST_P(PicStepCommands, SetParameters4_SpeedMode10Is2x) {
    expectSpeedMode(2, 2'000);
}
TEST_P(PicStepCommands, SetParameters5_SpeedMode11Is1x) {
    expectSpeedMode(3, 1'000);
}

TEST_P(PicStepCommands, SetParameters6_Bit2DisablesTheLimitSwitchAutostop) {
    set("limit1 1");
    parameters(k1x);
    run();
    EXPECT_FALSE(moving());
    parameters(k1x | kIgnoreLimits);
    run();
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
}

TEST_P(PicStepCommands, SetParameters7_Bit3DisablesTheEStop) {
    set("estop 1");
    parameters(k1x);
    run();
    EXPECT_FALSE(moving());
    parameters(k1x | kIgnoreEstop);
    run();
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
}

TEST_P(PicStepCommands, SetParameters8_Bit4TurnsTheMotorOffOnLimitOrEStop) {
    for (const std::string pin : {"limit1", "estop"}) {
        for (const unsigned off : {0U, kMotorOffAtLimit}) {
            stop(0x01);
            parameters(k1x | off);
            run();
            set(pin + " 1");
            EXPECT_EQ(status(), off == 0 ? 0x0CU : 0x08U) << pin;
            set(pin + " 0");
        }
    }
}

TEST_P(PicStepCommands, SetParameters9_Bits5To7AreIgnored) {
    expectSpeedMode(0xE0 | k1x, 1'000);
    EXPECT_EQ(rig->remarks(), Kinds{"reserved_bits"});
    set("limit1 1");
    EXPECT_EQ(status(), 0x0CU) << "the autostop is on, and the motor not turned off";
}

TEST_P(PicStepCommands, SetParameters10_TheSecondByteIsTheMinimumProfileSpeed) {
    parameters(k1x, 70);
    load({.speed = 120, .acceleration = 255});  // 64 ms for each
    EXPECT_EQ(speed(), 70U);
    stop(0x05);
    parameters(k1x, 90);
    load({});
    EXPECT_EQ(speed(), 90U);
}

TEST_P(PicStepCommands, SetParameters11_TheMinimumProfileSpeedIsFrom1To250) {
    for (const unsigned good : {1U, 250U})
        parameters(k1x, good);
    expectNoViolations();
    for (const unsigned bad : {0U, 251U})
        parameters(k1x, bad);
    expectViolations({"out_of_range", "out_of_range"});
}

TEST_P(PicStepCommands, SetParameters12_TheThirdByteIsTheRunningCurrentLimit) {
    for (const unsigned limit : {0U, 17U, 255U}) {
        parameters(k1x, 1, limit, 80);
        run();
        EXPECT_EQ(truth<unsigned>("current_limit"), limit);
        stop(0x05);
    }
}

TEST_P(PicStepCommands, SetParameters13_TheFourthByteIsTheHoldingCurrentLimit) {
    for (const unsigned limit : {0U, 17U, 255U}) {
        parameters(k1x, 1, 200, limit);
        EXPECT_EQ(truth<unsigned>("current_limit"), limit);
    }
}

TEST_P(PicStepCommands, SetParameters14_TheFifthByteIsTheThermalLimit) {
    set("analog 150");
    parameters(k1x, 1, 200, 80, 149);
    EXPECT_TRUE(amplifier());
    parameters(k1x, 1, 200, 80, 151);
    EXPECT_FALSE(amplifier());
    expectNoViolations();
}

TEST_P(PicStepCommands, SetParameters15_MustComeBeforeAnyMotion) {
    run();
    expectViolations({"parameters_not_set"});
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    parameters(k1x);
    run();
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    expectViolations({"parameters_not_set"});
}

TEST_P(PicStepCommands, SetParameters16_InMotionSpeedModeAndMinimumSpeedAreIgnored) {
    cruise();
    parameters(k8x, 60, 111);
    EXPECT_NEAR(stepsIn(kEightSeconds), 24'000, 1);
    EXPECT_EQ(truth<int>("current_limit"), 111) << "the other parameters take effect";
    load({.speed = 1});
    rig->wait(milliseconds(200));
    EXPECT_NEAR(stepsIn(kEightSeconds), 8 * 20 * 25, 1);
    stop(0x05);
    load({});
    EXPECT_NEAR(truth<double>("step_rate"), 20 * 25, 1e-9) << "they do not take effect later either";
    expectNoViolations();
}

// ---- Stop Motor ----

TEST_P(PicStepCommands, StopMotor1_IsCommand7WithOneByte) {
    expectForm("stop_motor", 0x17, {0x01});
}

TEST_P(PicStepCommands, StopMotor2_Bit0SetEnablesTheAmplifier) {
    for (const unsigned control : {0x01U, 0x05U, 0x09U}) {
        stop(0x00);
        stop(control);
        EXPECT_TRUE(amplifier()) << control;
    }
}

TEST_P(PicStepCommands, StopMotor3_Bit0ClearedDisablesTheAmplifierWhateverTheOtherBits) {
    for (const unsigned control : {0x00U, 0x04U, 0x08U}) {
        stop(0x01);
        stop(control);
        EXPECT_FALSE(amplifier()) << control;
    }
}

TEST_P(PicStepCommands, StopMotor4_Bit1IsNotUsed) {
    cruise();
    stop(0x03);
    EXPECT_NEAR(stepsIn(kEightSeconds), 24'000, 1);
    EXPECT_TRUE(amplifier());
}

TEST_P(PicStepCommands, StopMotor5_Bit2StopsAbruptlyAtTheCurrentPosition) {
    cruise();
    const std::int64_t there = position();
    stop(0x05);
    EXPECT_FALSE(moving());
    // Five bytes take 2.6 ms, the end of the tick comes within 0.512 ms: 7.8 to 9.3 steps.
    EXPECT_NEAR(truth<double>("position"), static_cast<double>(there) + 8.5, 1.5);
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStepCommands, StopMotor6_Bit3DeceleratesWithTheCurrentAccelerationTime) {
    cruise();
    rig->send(packet(1, 0x17, {0x09}));
    static_cast<void>(secondsToSpeed(119));
    // Speed 120 has lasted its millisecond; 119 ... 21 follow.
    EXPECT_NEAR(secondsToStop(), 0.099, 0.0006);
    expectNoViolations();
}

TEST_P(PicStepCommands, StopMotor7_Bits4To7AreNotUsed) {
    cruise();
    stop(0xF1);
    EXPECT_NEAR(stepsIn(kEightSeconds), 24'000, 1);
    EXPECT_TRUE(amplifier());
    expectViolations({"reserved_bits"});
}

TEST_P(PicStepCommands, StopMotor8_OnlyOneOfBits2And3MayBeSet) {
    for (const unsigned good : {0x01U, 0x05U, 0x09U})
        stop(good);
    expectNoViolations();
    stop(0x0D);
    expectViolations({"stop_bits"});
}

TEST_P(PicStepCommands, StopMotor9_ASmoothStopEndsWhenTheMinimumProfileSpeedIsReached) {
    cruise();
    stop(0x09);
    unsigned slowest = speed();
    while (moving()) {
        slowest = speed();
        rig->wait(kTick);
    }
    EXPECT_NEAR(slowest, 21.0, 1.0);
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStepCommands, StopMotor10_AfterASmoothStopATrapezoidNeedsItsSpeedLoadedAgain) {
    cruise();
    stop(0x09);
    static_cast<void>(secondsToStop());
    const auto goal = static_cast<std::int32_t>(position()) + 5'000;
    load({.position = goal});
    rig->wait(milliseconds(500));
    EXPECT_EQ(speed(), 20U) << "the minimum, because the speed is 0";
    expectViolations({"velocity_not_loaded"});
    stop(0x05);
    load({.position = goal, .speed = 120});
    rig->wait(milliseconds(500));
    EXPECT_EQ(speed(), 120U);
    stop(0x05);
    load({.position = 0});
    rig->wait(milliseconds(500));
    EXPECT_EQ(speed(), 120U) << "loaded before, and no smooth stop since";
    expectViolations({"velocity_not_loaded"});
}

TEST_P(PicStepCommands, StopMotor11_EnablesTheAmplifierAtFirstAndNothingElseDoes) {
    powerUp();
    rig->address(1);
    parameters(k1x);
    run();
    EXPECT_FALSE(amplifier());
    stop(0x01);
    EXPECT_TRUE(amplifier());
}

TEST_P(PicStepCommands, StopMotor12_TheAmplifierCanBeEnabledWithoutAStop) {
    powerUp();
    rig->address(1);
    parameters(k1x);
    run();
    stop(0x01);
    EXPECT_NEAR(stepsIn(kEightSeconds), 8'000, 1);
    expectNoViolations();
}

TEST_P(PicStepCommands, StopMotor13_AnAccelerationTimeThatWaitsForStartMotionIsNotTheCurrentOne) {
    cruise();
    load({.acceleration = 255, .start = false});
    rig->send(packet(1, 0x17, {0x09}));
    static_cast<void>(secondsToSpeed(119));
    EXPECT_NEAR(secondsToStop(), 0.099, 0.0006) << "1 ms at each of 119 ... 21";
    load({.speed = 22});
    rig->wait(seconds(1));
    rig->send(packet(1, 0x17, {0x09}));
    static_cast<void>(secondsToSpeed(21));
    EXPECT_NEAR(secondsToStop(), 0.06375, 0.0006) << "started: 255 times 0.25 ms at 21";
    expectNoViolations();
}

// ---- Set Outputs ----

TEST_P(PicStepCommands, SetOutputs1_IsCommand8WithOneByte) {
    expectForm("set_outputs", 0x18, {0x00});
}
TEST_P(PicStepCommands, SetOutputs2_Bit0IsOut1) {
    expectOutput(0x01);
}
TEST_P(PicStepCommands, SetOutputs3_Bit1IsOut2) {
    expectOutput(0x02);
}
TEST_P(PicStepCommands, SetOutputs4_Bit2IsOut3) {
    expectOutput(0x04);
}
TEST_P(PicStepCommands, SetOutputs5_Bit3IsOut4) {
    expectOutput(0x08);
}
TEST_P(PicStepCommands, SetOutputs6_Bit4IsOut5) {
    expectOutput(0x10);
}
TEST_P(PicStepCommands, SetOutputs7_Bits5To7ReachNoOutput) {
    command(0x18, {0xE5});
    EXPECT_EQ(truth<int>("outputs"), 0x05);
    expectViolations({"reserved_bits"});
}

}  // namespace
}  // namespace nmc::conformance
