// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.3, the status byte and the auxiliary status byte, and 5.2 Clear Sticky Bits.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

class PicServoBits : public PicServo {
protected:
    bool has(unsigned bit) { return (status().byte & bit) != 0; }
    bool auxiliaryHas(unsigned bit) { return (status().auxiliary & bit) != 0; }
    void clearStickyBits() { command(0x0B); }

    void overcurrent() {
        gains({.cl = 101});
        rig->must("set 1 analog 200");
        rig->waitTicks(2);
        rig->must("set 1 analog 0");
        rig->waitTicks(2);
    }
    void excessError() {
        servoOn({.kp = 200, .kd = 2000, .el = 50});
        stopHere(100);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoBits, kPlaces, nameOf);

TEST_P(PicServoBits, StatusByte0_MoveDoneIsClearInATrapezoidAndWhileTheVelocityChanges) {
    EXPECT_TRUE(has(kMoveDone)) << "the servo is off";
    servoOn();
    EXPECT_TRUE(has(kMoveDone));
    trapezoid(500, 2 * kOne, kOne);
    EXPECT_FALSE(has(kMoveDone));
    rig->waitTicks(300);
    EXPECT_TRUE(has(kMoveDone));
    velocity(2 * kOne, kOne / 64);
    EXPECT_FALSE(has(kMoveDone));
    rig->waitTicks(128);
    EXPECT_TRUE(has(kMoveDone)) << "the velocity is reached";
    velocity(kOne, kOne / 128);
    EXPECT_FALSE(has(kMoveDone)) << "from one velocity to the next";
    stop(kAmplifier | kMotorOff);
    EXPECT_TRUE(has(kMoveDone));
}

TEST_P(PicServoBits, StatusByte1_ChecksumErrorIsAboutThePacketJustReceived) {
    EXPECT_EQ(rig->exchange({0xAA, 0x01, 0x0E, 0x10}), (Bytes{0x1B, 0x1B}));
    EXPECT_EQ(rig->exchange({0xAA, 0x01, 0x0E, 0x0F}), (Bytes{0x19, 0x19}));
}

TEST_P(PicServoBits, StatusByte2_OvercurrentIsSetWhenCurrentLimitingOccurredAndStays) {
    EXPECT_FALSE(has(kOvercurrent));
    overcurrent();
    EXPECT_TRUE(has(kOvercurrent));
    rig->wait(milliseconds(500));
    EXPECT_TRUE(has(kOvercurrent));
}

TEST_P(PicServoBits, StatusByte3_PowerOnIsTheMotorsPower) {
    EXPECT_TRUE(has(kPowerOn));
    rig->must("set 1 power 0");
    EXPECT_FALSE(has(kPowerOn));
    rig->must("set 1 power 1");
    EXPECT_TRUE(has(kPowerOn));
}

TEST_P(PicServoBits, StatusByte4_PositionErrorIsSetByAnExcessErrorAndWheneverTheServoIsOff) {
    EXPECT_TRUE(has(kPositionError)) << "the servo is off";
    clearStickyBits();
    EXPECT_TRUE(has(kPositionError)) << "the servo is still off";
    servoOn();
    EXPECT_FALSE(has(kPositionError));
    excessError();
    EXPECT_TRUE(has(kPositionError));
    stop(kAmplifier | kAbruptly);
    EXPECT_TRUE(has(kPositionError)) << "it stays set until it is cleared";
}

TEST_P(PicServoBits, StatusByte5_Limit1IsTheValueOfTheInput) {
    EXPECT_FALSE(has(kLimit1));
    rig->must("set 1 limit1 1");
    EXPECT_TRUE(has(kLimit1));
    EXPECT_FALSE(has(kLimit2));
    rig->must("set 1 limit1 0");
    EXPECT_FALSE(has(kLimit1));
}

TEST_P(PicServoBits, StatusByte6_Limit2IsTheValueOfTheInput) {
    EXPECT_FALSE(has(kLimit2));
    rig->must("set 1 limit2 1");
    EXPECT_TRUE(has(kLimit2));
    EXPECT_FALSE(has(kLimit1));
    rig->must("set 1 limit2 0");
    EXPECT_FALSE(has(kLimit2));
}

TEST_P(PicServoBits, StatusByte7_HomeInProgressIsSetWhileSearching) {
    EXPECT_FALSE(has(kHomeInProgress));
    homing(0x01);
    rig->wait(milliseconds(500));
    EXPECT_TRUE(has(kHomeInProgress));
    rig->must("set 1 limit1 1");
    EXPECT_FALSE(has(kHomeInProgress));
}

TEST_P(PicServoBits, AuxByte0_IsTheComplementOfTheIndex) {
    for (const char* level : {"1", "0", "1"}) {
        rig->must(std::string("set 1 index ") + level);
        EXPECT_EQ(auxiliaryHas(kIndexLow), *level == '0');
    }
}

TEST_P(PicServoBits, AuxByte1_PositionWrapIsSetWhenThe32BitCounterWrapsAndStays) {
    EXPECT_FALSE(auxiliaryHas(kPositionWrap));
    wrapPosition();
    const Status s = status();
    EXPECT_LT(s.position, 0) << "beyond the largest positive number";
    EXPECT_EQ(s.auxiliary & kPositionWrap, kPositionWrap);
    EXPECT_TRUE(auxiliaryHas(kPositionWrap));
}

TEST_P(PicServoBits, AuxByte2_ServoOnIsSetWhileThePositionServoIsEnabled) {
    EXPECT_FALSE(auxiliaryHas(kServoOn));
    servoOn();
    EXPECT_TRUE(auxiliaryHas(kServoOn));
    stop(kAmplifier | kMotorOff);
    EXPECT_FALSE(auxiliaryHas(kServoOn));
}

TEST_P(PicServoBits, AuxByte3_AccelerationDoneIsSetAfterTheFirstPhaseAndClearedByTheNextStart) {
    servoOn();
    trapezoid(4000, 4 * kOne, kOne / 64);  // 256 ticks up, 744 at speed, 256 down
    EXPECT_FALSE(auxiliaryHas(kAccelerationDone));
    rig->waitTicks(300);
    EXPECT_TRUE(auxiliaryHas(kAccelerationDone));
    rig->waitTicks(1000);
    EXPECT_TRUE(auxiliaryHas(kAccelerationDone));
    trapezoid(8000, 4 * kOne, kOne / 64);
    EXPECT_FALSE(auxiliaryHas(kAccelerationDone));
}

TEST_P(PicServoBits, AuxByte4_SlewDoneIsSetAfterTheSecondPhaseAndClearedByTheNextStart) {
    servoOn();
    trapezoid(4000, 4 * kOne, kOne / 64);
    rig->waitTicks(800);
    EXPECT_FALSE(auxiliaryHas(kSlewDone));
    rig->waitTicks(230);
    const Status s = status();
    EXPECT_EQ(s.auxiliary & kSlewDone, kSlewDone);
    EXPECT_EQ(s.byte & kMoveDone, 0U) << "slowing down";
    trapezoid(8000, 4 * kOne, kOne / 64);
    EXPECT_FALSE(auxiliaryHas(kSlewDone));
}

TEST_P(PicServoBits, AuxByte5_ServoOverrunIsSetWhenATickTakesTooLongAndStays) {
    EXPECT_FALSE(auxiliaryHas(kServoOverrun));
    rig->must("set 1 servo_overrun 1");
    EXPECT_TRUE(auxiliaryHas(kServoOverrun));
    rig->wait(milliseconds(500));
    EXPECT_TRUE(auxiliaryHas(kServoOverrun));
}

TEST_P(PicServoBits, ClearStickyBits1_ClearsOvercurrent) {
    overcurrent();
    clearStickyBits();
    EXPECT_FALSE(has(kOvercurrent));
    expectNoViolation();
}

TEST_P(PicServoBits, ClearStickyBits2_ClearsPositionError) {
    excessError();
    stop(kAmplifier | kAbruptly);
    clearStickyBits();
    EXPECT_FALSE(has(kPositionError));
}

TEST_P(PicServoBits, ClearStickyBits3_ClearsPositionWrap) {
    wrapPosition();
    clearStickyBits();
    EXPECT_FALSE(auxiliaryHas(kPositionWrap));
}

TEST_P(PicServoBits, ClearStickyBits4_ClearsServoOverrun) {
    rig->must("set 1 servo_overrun 1");
    clearStickyBits();
    EXPECT_FALSE(auxiliaryHas(kServoOverrun));
}

TEST_P(PicServoBits, ClearStickyBits5_NothingElseClearsThem) {
    excessError();
    overcurrent();
    rig->must("set 1 servo_overrun 1");
    for (const unsigned code : {0x00U, 0x0CU, 0x0EU, 0x05U})
        command(code);
    gains(kGoodGains);
    stop(kAmplifier | kAbruptly);
    trapezoid(10, kOne, kOne);
    rig->waitTicks(100);
    EXPECT_TRUE(has(kOvercurrent));
    EXPECT_TRUE(has(kPositionError));
    EXPECT_TRUE(auxiliaryHas(kServoOverrun));
}

}  // namespace
}  // namespace nmc::conformance
