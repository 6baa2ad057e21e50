// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2: Define Status, Read Status, No Operation.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

constexpr unsigned kDefine = 0x12, kRead = 0x13;

/// Both commands have the same items; `by` is the one that is used.
class PicServoItems : public PicServo {
protected:
    Bytes items(unsigned by, unsigned mask) { return command(by, {static_cast<std::uint8_t>(mask)}); }

    void expectPosition(unsigned by) {
        turnAway();
        const Bytes answer = items(by, 0x01);
        ASSERT_EQ(answer.size(), 6U);
        EXPECT_EQ(longAt(answer, 1), truth("position"));
    }
    void expectAnalog(unsigned by) {
        rig->must("set 1 analog 79");
        EXPECT_EQ(items(by, 0x02), (Bytes{0x19, 79, 0x19 + 79}));
    }
    /// At PWM 60 the motor runs at (V - R Tc / K) / (K + R b / K) = (5.647 - 0.116) / 0.038029 = 145.4 rad/s,
    /// which is 23.7 counts per tick.
    void expectVelocity(unsigned by) {
        stop(kAmplifier);
        pwm(60);
        rig->wait(milliseconds(300));
        const Bytes forward = items(by, 0x04);
        ASSERT_EQ(forward.size(), 4U);
        EXPECT_NEAR(static_cast<std::int16_t>(wordAt(forward, 1)), -23.7, 1);
        pwm(-60);
        rig->wait(milliseconds(300));
        EXPECT_NEAR(static_cast<std::int16_t>(wordAt(items(by, 0x04), 1)), 23.7, 1);
    }
    void expectAuxiliary(unsigned by) {
        EXPECT_EQ(items(by, 0x08), (Bytes{0x19, 0x00, 0x19}));
        rig->must("set 1 index 0");
        EXPECT_EQ(items(by, 0x08), (Bytes{0x19, 0x01, 0x1A}));
    }
    void expectHome(unsigned by) {
        turnAway();
        command(0x0C);
        const int home = truth("position");
        command(0x00);
        const Bytes answer = items(by, 0x10);
        ASSERT_EQ(answer.size(), 6U);
        EXPECT_EQ(longAt(answer, 1), home);
    }
    void expectIdentity(unsigned by) {
        for (unsigned version = 1; version <= 4; ++version) {
            start("servo@" + std::to_string(version), 1);
            EXPECT_EQ(items(by, 0x20),
                      (Bytes{0x19, 0, static_cast<std::uint8_t>(version), little(0x19 + version, 1)[0]}));
        }
    }
    void expectNothingInBits6And7(unsigned by) {
        EXPECT_EQ(items(by, 0xC0), (Bytes{0x19, 0x19}));
        expectViolation("reserved_bits");
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoItems, kPlaces, nameOf);

TEST_P(PicServoItems, DefineStatus1_Bit0SendsThePositionInFourBytes) {
    expectPosition(kDefine);
}
TEST_P(PicServoItems, DefineStatus2_Bit1SendsTheAnalogValueInOneByte) {
    expectAnalog(kDefine);
}
TEST_P(PicServoItems, DefineStatus3_Bit2SendsTheNegativeVelocityInCountsPerTickInTwoBytes) {
    expectVelocity(kDefine);
}
TEST_P(PicServoItems, DefineStatus4_Bit3SendsTheAuxiliaryStatusByte) {
    expectAuxiliary(kDefine);
}
TEST_P(PicServoItems, DefineStatus5_Bit4SendsTheHomePositionInFourBytes) {
    expectHome(kDefine);
}
TEST_P(PicServoItems, DefineStatus6_Bit5SendsDevice0AndTheVersion) {
    expectIdentity(kDefine);
}
TEST_P(PicServoItems, DefineStatus7_Bits6And7SendNothing) {
    expectNothingInBits6And7(kDefine);
}

TEST_P(PicServoItems, ReadStatus1_Bit0SendsThePositionInFourBytes) {
    expectPosition(kRead);
}
TEST_P(PicServoItems, ReadStatus2_Bit1SendsTheAnalogValueInOneByte) {
    expectAnalog(kRead);
}
TEST_P(PicServoItems, ReadStatus3_Bit2SendsTheNegativeVelocityInCountsPerTickInTwoBytes) {
    expectVelocity(kRead);
}
TEST_P(PicServoItems, ReadStatus4_Bit3SendsTheAuxiliaryStatusByte) {
    expectAuxiliary(kRead);
}
TEST_P(PicServoItems, ReadStatus5_Bit4SendsTheHomePositionInFourBytes) {
    expectHome(kRead);
}
TEST_P(PicServoItems, ReadStatus6_Bit5SendsDevice0AndTheVersion) {
    expectIdentity(kRead);
}
TEST_P(PicServoItems, ReadStatus7_Bits6And7SendNothing) {
    expectNothingInBits6And7(kRead);
}

TEST_P(PicServoItems, DefineStatus8_TheItemsComeInTheOrderListed) {
    turnAway();
    command(0x0C);
    rig->must("set 1 analog 79");
    rig->must("set 1 index 0");
    const Bytes here = position(truth("position"));
    EXPECT_EQ(items(kDefine, 0x09), (Bytes{0x19} + here + Bytes{0x01} + sumOf(Bytes{0x1A} + here)));
    const Bytes all = Bytes{0x19} + here + Bytes{79, 0, 0, 0x01} + here + Bytes{0, 4};
    EXPECT_EQ(items(kDefine, 0x3F), all + sumOf(all));
}

TEST_P(PicServoItems, DefineStatus9_ItsOwnReplyHasTheItemsAlready) {
    EXPECT_EQ(items(kDefine, 0x20).size(), 4U);
}

TEST_P(PicServoItems, DefineStatus10_EveryLaterReplyHasTheItems) {
    items(kDefine, 0x20);
    EXPECT_EQ(command(0x0E).size(), 4U);
    EXPECT_EQ(command(0x0B).size(), 4U);
    items(kDefine, 0x01);
    EXPECT_EQ(command(0x0E).size(), 6U);
}

TEST_P(PicServoItems, DefineStatus11_AtPowerUpThereIsOnlyTheStatusByte) {
    items(kDefine, 0x3F);
    command(0x0F);
    rig->wait(milliseconds(10));
    EXPECT_EQ(rig->command(0, 0x0E), (Bytes{0x19, 0x19}));
}

TEST_P(PicServoItems, ReadStatus8_LaterRepliesHaveWhatDefineStatusSaid) {
    items(kDefine, 0x08);
    EXPECT_EQ(items(kRead, 0x30).size(), 8U);
    EXPECT_EQ(command(0x0E).size(), 3U);
    EXPECT_EQ(items(kRead, 0x00).size(), 2U);
    EXPECT_EQ(command(0x0E).size(), 3U);
}

TEST_P(PicServoItems, NoOperation1_DoesNothingButCauseAStatusPacketWithTheDefinedItems) {
    const nlohmann::json before = rig->state();
    EXPECT_EQ(command(0x0E), (Bytes{0x19, 0x19}));
    nlohmann::json after = rig->state();
    for (const char* name : {"time", "tick"})
        after[name] = before[name];
    EXPECT_EQ(after, before);
    items(kDefine, 0x20);
    EXPECT_EQ(command(0x0E), (Bytes{0x19, 0x00, 0x04, 0x1D}));
    expectNoViolation();
}

}  // namespace
}  // namespace nmc::conformance
