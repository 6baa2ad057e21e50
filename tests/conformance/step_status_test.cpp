// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1: Define Status, Read Status, No Operation; 5.2: the status byte.
#include "tests/conformance/picstep.h"

namespace nmc::conformance {
namespace {

class PicStepStatus : public PicStep {
protected:
    PicStepStatus() { parameters(k1x, 20); }
    /// Sets home at 258 = 0x0102 and moves to -515 = 0xFFFFFDFD at 1000 steps per second; A/D is 0x55, and
    /// the inputs are 0x22.
    void arrange() {
        moveTo(258);
        command(0x0C);
        moveTo(-515);
        set("analog 85");
        set("in1 1");
        set("home_switch 1");
    }
    void expectItem(unsigned byte, unsigned mask, const Bytes& item, const Kinds& violations = {});
};

INSTANTIATE_TEST_SUITE_P(, PicStepStatus, kPlaces, nameOf);

/// Checks the answer to Define Status or Read Status: status byte, the item, the sum.
void PicStepStatus::expectItem(unsigned byte, unsigned mask, const Bytes& item, const Kinds& violations) {
    arrange();
    Bytes expected{0x0C};
    expected = expected + item;
    unsigned sum = 0;
    for (const std::uint8_t value : expected)
        sum += value;
    expected.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
    EXPECT_EQ(command(byte, {static_cast<std::uint8_t>(mask)}), expected);
    expectViolations(violations);
}

const Bytes kPositionItem{0xFD, 0xFD, 0xFF, 0xFF}, kAnalogItem{0x55}, kTimerItem{0x91, 0xFD},
    kInputsItem{0x22}, kHomeItem{0x02, 0x01, 0x00, 0x00}, kIdentityItem{3, 1};

TEST_P(PicStepStatus, DefineStatus1_IsCommand2WithOneByte) {
    expectForm("define_status", 0x12, {0x00});
}
TEST_P(PicStepStatus, DefineStatus2_TheDefaultIsNoItem) {
    arrange();
    EXPECT_EQ(command(0x0E), (Bytes{0x0C, 0x0C}));
}
TEST_P(PicStepStatus, DefineStatus3_Bit0SendsThePositionInFourBytes) {
    expectItem(0x12, 0x01, kPositionItem);
}
TEST_P(PicStepStatus, DefineStatus4_Bit1SendsTheAnalogValueInOneByte) {
    expectItem(0x12, 0x02, kAnalogItem);
}
TEST_P(PicStepStatus, DefineStatus5_Bit2SendsTheCurrentInitialTimerCountInTwoBytes) {
    expectItem(0x12, 0x04, kTimerItem);
}
TEST_P(PicStepStatus, DefineStatus6_Bit3SendsTheInputsByte) {
    expectItem(0x12, 0x08, kInputsItem);
}
TEST_P(PicStepStatus, DefineStatus7_Bit4SendsTheHomePositionInFourBytes) {
    expectItem(0x12, 0x10, kHomeItem);
}
TEST_P(PicStepStatus, DefineStatus8_Bit5SendsDeviceType3AndTheVersion) {
    expectItem(0x12, 0x20, kIdentityItem);
}
TEST_P(PicStepStatus, DefineStatus9_Bits6And7AreNotUsed) {
    expectItem(0x12, 0xC8, kInputsItem, {"reserved_bits"});
}
TEST_P(PicStepStatus, DefineStatus10_ItemsComeInTheOrderListed) {
    expectItem(0x12, 0x3F,
               kPositionItem + kAnalogItem + kTimerItem + kInputsItem + kHomeItem + kIdentityItem);
}
TEST_P(PicStepStatus, DefineStatus11_Bits0And3GivePositionThenInputsThenTheSum) {
    expectItem(0x12, 0x09, kPositionItem + kInputsItem);
}

TEST_P(PicStepStatus, DefineStatus12_TheReplyToTheCommandHasTheItemsAlready) {
    EXPECT_EQ(command(0x12, {0x20}), (Bytes{0x0C, 3, 1, 0x10}));
    EXPECT_EQ(command(0x12, {0x00}), (Bytes{0x0C, 0x0C}));
}

TEST_P(PicStepStatus, DefineStatus13_LaterStatusPacketsHaveTheItems) {
    command(0x12, {0x20});
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(command(0x0E), (Bytes{0x0C, 3, 1, 0x10}));
    EXPECT_EQ(command(0x17, {0x00}), (Bytes{0x08, 3, 1, 0x0C}));
}

TEST_P(PicStepStatus, DefineStatus14_APowerUpOrResetLeavesTheStatusByteOnly) {
    for (const bool reset : {false, true}) {
        command(0x12, {0x3F});
        if (reset)
            command(0x0F);
        else
            rig->must("power-cycle 1");
        rig->waitTicks(20);
        rig->address(1);
        EXPECT_EQ(command(0x0E), (Bytes{0x08, 0x08}));
    }
}

TEST_P(PicStepStatus, DefineStatus15_ValuesOfSeveralBytesComeLeastSignificantFirst) {
    expectItem(0x12, 0x15, kPositionItem + kTimerItem + kHomeItem);
}

TEST_P(PicStepStatus, ReadStatus1_IsCommand3WithOneByte) {
    expectForm("read_status", 0x13, {0x00});
}
TEST_P(PicStepStatus, ReadStatus2_Bit0SendsThePositionInFourBytes) {
    expectItem(0x13, 0x01, kPositionItem);
}
TEST_P(PicStepStatus, ReadStatus3_Bit1SendsTheAnalogValueInOneByte) {
    expectItem(0x13, 0x02, kAnalogItem);
}
TEST_P(PicStepStatus, ReadStatus4_Bit2SendsTheCurrentInitialTimerCountInTwoBytes) {
    expectItem(0x13, 0x04, kTimerItem);
}
TEST_P(PicStepStatus, ReadStatus5_Bit3SendsTheInputsByte) {
    expectItem(0x13, 0x08, kInputsItem);
}
TEST_P(PicStepStatus, ReadStatus6_Bit4SendsTheHomePositionInFourBytes) {
    expectItem(0x13, 0x10, kHomeItem);
}
TEST_P(PicStepStatus, ReadStatus7_Bit5SendsDeviceType3AndTheVersion) {
    expectItem(0x13, 0x20, kIdentityItem);
}
TEST_P(PicStepStatus, ReadStatus8_Bits6And7AreNotUsed) {
    expectItem(0x13, 0xC8, kInputsItem, {"reserved_bits"});
}
TEST_P(PicStepStatus, ReadStatus9_TheReplyHasTheItemsOfTheCommand) {
    expectItem(0x13, 0x3F,
               kPositionItem + kAnalogItem + kTimerItem + kInputsItem + kHomeItem + kIdentityItem);
}

TEST_P(PicStepStatus, ReadStatus10_LaterPacketsHaveTheItemsOfDefineStatus) {
    command(0x12, {0x20});
    EXPECT_EQ(command(0x13, {0x01}), (Bytes{0x0C, 0, 0, 0, 0, 0x0C}));
    EXPECT_EQ(command(0x0E), (Bytes{0x0C, 3, 1, 0x10}));
}

TEST_P(PicStepStatus, NoOperation1_IsCommandEWithoutData) {
    expectForm("nop", 0x0E, {});
}

TEST_P(PicStepStatus, NoOperation2_DoesNothingButReturnTheDefinedStatus) {
    arrange();
    command(0x12, {0x08});
    const auto before = rig->state();
    EXPECT_EQ(command(0x0E), (Bytes{0x0C, 0x22, 0x2E}));
    auto after = rig->state();
    for (const char* clock : {"time", "tick"})
        after[clock] = before[clock];
    EXPECT_EQ(after, before);
    expectNoViolations();
}

// ---- 5.2, Status byte ----

TEST_P(PicStepStatus, StatusByte0_TheMotorIsMoving) {
    EXPECT_EQ(status() & 0x01U, 0U);
    load({.position = 300, .count = kCount});
    EXPECT_EQ(status() & 0x01U, 0x01U);
    static_cast<void>(secondsToStop());
    EXPECT_EQ(status() & 0x01U, 0U);
}

TEST_P(PicStepStatus, StatusByte1_CommunicationsError) {
    Bytes wrong = packet(1, 0x17, {0x00});
    wrong.back() ^= 1U;
    EXPECT_EQ(rig->exchange(wrong), (Bytes{0x0E, 0x0E}));
    EXPECT_EQ(status(), 0x0CU) << "the command was not executed";
}

TEST_P(PicStepStatus, StatusByte2_TheAmplifierEnableOutputIsHigh) {
    for (const unsigned enable : {0U, 1U, 0U}) {
        stop(enable);
        EXPECT_EQ(status() & 0x04U, enable * 0x04U);
        EXPECT_EQ(truth<bool>("amp_enabled"), enable == 1);
    }
}

TEST_P(PicStepStatus, StatusByte3_ThePowerSenseInputIsHigh) {
    for (const unsigned level : {0U, 1U}) {
        set("power " + std::to_string(level));
        EXPECT_EQ(status() & 0x08U, level * 0x08U);
    }
}

TEST_P(PicStepStatus, StatusByte4_AtCommandedSpeed) {
    EXPECT_EQ(status() & 0x10U, 0U);
    load({.speed = 120, .acceleration = 4});  // 100 ms
    EXPECT_EQ(status() & 0x10U, 0U);
    rig->wait(milliseconds(100));
    EXPECT_EQ(status() & 0x10U, 0x10U);
    load({.speed = 20});
    EXPECT_EQ(status() & 0x10U, 0U);
    rig->wait(milliseconds(100));
    EXPECT_EQ(status() & 0x10U, 0x10U);
}

TEST_P(PicStepStatus, StatusByte5_VelocityProfileMode) {
    load({.speed = 30, .acceleration = 4});
    EXPECT_EQ(status() & 0x60U, 0x20U);
    load({.count = kCount, .nearest = kNearest});
    EXPECT_EQ(status() & 0x60U, 0U);
}

TEST_P(PicStepStatus, StatusByte6_TrapezoidalProfileMode) {
    load({.position = 1'000, .speed = 30, .acceleration = 4});
    EXPECT_EQ(status() & 0x60U, 0x40U);
    load({.count = kCount, .nearest = kNearest});
    EXPECT_EQ(status() & 0x60U, 0U);
}

TEST_P(PicStepStatus, StatusByte7_HomingInProgress) {
    EXPECT_EQ(status() & 0x80U, 0U);
    command(0x19, {0x08});
    EXPECT_EQ(status() & 0x80U, 0x80U);
    set("home_switch 1");
    EXPECT_EQ(status() & 0x80U, 0U);
}

}  // namespace
}  // namespace nmc::conformance
