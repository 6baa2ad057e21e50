// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 2.3: the pins; 5.2: the inputs byte.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

TEST_P(PicStep, Pins1_ResetReturnsTheChipToPowerUp) {
    command(0x18, {0x03});
    rig->must("power-cycle 1");
    rig->waitTicks(20);
    EXPECT_EQ(truth<int>("outputs"), 0x10);
    EXPECT_EQ(truth<int>("address"), 0);
    EXPECT_EQ(rig->command(0, 0x0E), (Bytes{0x08, 0x08}));
}

TEST_P(PicStep, Pins2_TempSensIsReadFrom0To255) {
    for (const unsigned value : {0U, 1U, 128U, 255U}) {
        set("analog " + std::to_string(value));
        EXPECT_EQ(byteAt(command(0x13, {0x02}), 1), value);
    }
}

TEST_P(PicStep, Pins3_AddrOutIsHighAtFirstAndStaysLowAfterSetAddress) {
    make("step,step", {"--deaf-when-addr-in-rises"});
    EXPECT_EQ(rig->state(2)["listening"], false);
    ASSERT_EQ(rig->command(0, 0x21, {1, 0xFF}).size(), 2U);
    EXPECT_EQ(rig->state(2)["listening"], true);
    ASSERT_EQ(rig->command(0, 0x21, {2, 0xFF}).size(), 2U);
    ASSERT_EQ(rig->command(1, 0x21, {3, 0xFF}).size(), 2U) << "a second time";
    EXPECT_EQ(rig->command(2, 0x0E).size(), 2U) << "module 2 would be deaf if its ADDR_IN had risen";
}

TEST_P(PicStep, Pins4_Limit1IsAGeneralInputTooWhenItDoesNotStop) {
    parameters(k1x | kIgnoreLimits);
    run();
    set("limit1 1");
    EXPECT_EQ(report().inputs, 0x08U);
    EXPECT_TRUE(moving());
}

TEST_P(PicStep, Pins5_CommunicationIsDisabledUntilAddrInGoesLow) {
    powerUp("step,step");
    rig->must("break 1");
    ASSERT_EQ(rig->command(0, 0x21, {1, 0xFF}).size(), 2U);
    EXPECT_TRUE(rig->command(0, 0x0E).empty());
    rig->must("mend 1");
    EXPECT_EQ(rig->command(0, 0x0E), (Bytes{0x08, 0x08}));
}

TEST_P(PicStep, Pins6_HomeSwIsAGeneralInputToo) {
    parameters(k1x);
    run();
    set("home_switch 1");
    EXPECT_EQ(report().inputs, 0x20U);
    EXPECT_TRUE(moving());
}

TEST_P(PicStep, Pins7_Limit2IsAGeneralInputTooWhenItDoesNotStop) {
    parameters(k1x | kIgnoreLimits);
    run(true);
    set("limit2 1");
    EXPECT_EQ(report().inputs, 0x10U);
    EXPECT_TRUE(moving());
}

TEST_P(PicStep, Pins8_DirIsLowForForwardAndHighForReverse) {
    parameters(k1x);
    for (const bool reverse : {true, false}) {
        run(reverse);
        EXPECT_EQ(truth<bool>("reverse"), reverse);
        stop(0x05);
    }
}

TEST_P(PicStep, Pins9_AStepPulseMovesTheMotorByOneStep) {
    parameters(k1x);
    for (const std::int32_t goal : {7, 8, 5, -4}) {
        moveTo(goal);
        EXPECT_EQ(truth<int>("shaft"), goal);
    }
}

TEST_P(PicStep, Pins10_CurLimIsTheDriversCurrentLimit) {
    EXPECT_EQ(truth<int>("current_limit"), 0);
    for (const unsigned limit : {1U, 80U, 255U}) {
        parameters(k1x, 1, 0, limit);
        EXPECT_EQ(truth<unsigned>("current_limit"), limit);
    }
}

TEST_P(PicStep, Pins11_LowPwrSenseLowersAmpEnAndTerminatesMotion) {
    parameters(k1x | kIgnoreLimits | kIgnoreEstop);
    run();
    EXPECT_EQ(status(), 0x1DU);
    set("power 0");
    EXPECT_EQ(status(), 0x00U);
    EXPECT_EQ(stepsIn(seconds(1)), 0);
    set("power 1");
    EXPECT_EQ(status(), 0x08U) << "it stays off until it is enabled again";
    stop(0x01);
    run();
    EXPECT_EQ(status(), 0x1DU) << "normal operation";
}

TEST_P(PicStep, Pins12_AmpEnHighEnablesTheDriverAndLowDisablesIt) {
    parameters(k1x);
    moveTo(50);
    EXPECT_EQ(truth<int>("shaft"), 50);
    stop(0x00);
    EXPECT_FALSE(truth<bool>("amp_enabled"));
    moveTo(80);
    EXPECT_EQ(truth<int>("shaft"), 50) << "a disabled driver does not turn the motor";
}

TEST_P(PicStep, Pins13_XmtEnLetsModulesShareTheStatusLine) {
    fresh("step,step,step");
    for (unsigned address : {3U, 1U, 2U})
        EXPECT_EQ(rig->command(address, 0x13, {0x20}).size(), 4U);
    rig->command(0xFF, 0x0E);
    expectNoViolations();
}

TEST_P(PicStep, Pins14_EstopHighTerminatesMotion) {
    parameters(k1x);
    run();
    set("estop 1");
    rig->waitTicks(2);
    EXPECT_FALSE(moving());
    EXPECT_EQ(stepsIn(seconds(1)), 0);
}

TEST_P(PicStep, Pins15_In1IsAGeneralInput) {
    set("in1 1");
    EXPECT_EQ(report().inputs, 0x02U);
    set("in1 0");
    EXPECT_EQ(report().inputs, 0x00U);
}

TEST_P(PicStep, Pins16_In2IsAGeneralInput) {
    set("in2 1");
    EXPECT_EQ(report().inputs, 0x04U);
    set("in2 0");
    EXPECT_EQ(report().inputs, 0x00U);
}

TEST_P(PicStep, Pins17_Out1To4AreLowAfterPowerUp) {
    powerUp();
    EXPECT_EQ(truth<unsigned>("outputs") & 0x0FU, 0U);
    rig->command(0, 0x18, {0x0F});
    EXPECT_EQ(truth<unsigned>("outputs") & 0x0FU, 0x0FU);
}

TEST_P(PicStep, Pins18_Out5IsHighAfterPowerUp) {
    powerUp();
    EXPECT_EQ(truth<unsigned>("outputs") & 0x10U, 0x10U);
    rig->command(0, 0x18, {0x0F});
    EXPECT_EQ(truth<unsigned>("outputs") & 0x10U, 0U);
}

// ---- 5.2, Inputs byte ----

TEST_P(PicStep, InputsByte0_IsTheEStopInput) {
    expectInput("estop", 0x01U);
}
TEST_P(PicStep, InputsByte1_IsIn1) {
    expectInput("in1", 0x02U);
}
TEST_P(PicStep, InputsByte2_IsIn2) {
    expectInput("in2", 0x04U);
}
TEST_P(PicStep, InputsByte3_IsTheForwardLimitSwitch) {
    expectInput("limit1", 0x08U);
}
TEST_P(PicStep, InputsByte4_IsTheReverseLimitSwitch) {
    expectInput("limit2", 0x10U);
}
TEST_P(PicStep, InputsByte5_IsTheHomingSwitch) {
    expectInput("home_switch", 0x20U);
}

}  // namespace
}  // namespace nmc::conformance
