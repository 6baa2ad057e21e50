// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 5.2: Set Homing Mode.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

class PicServoHoming : public PicServo {
protected:
    PicServoHoming() { run(); }
    /// Runs in velocity mode at 2 counts per tick, from which a stop takes 64 ticks.
    void run() {
        servoOn({.kp = 200, .kd = 2000, .ki = 20, .il = 200, .el = 500});
        velocity(2 * kOne, kOne / 32);
        rig->waitTicks(200);
    }
    void run(const std::string& version) {
        start(version, 1);
        run();
    }
    bool searching() { return (status().byte & kHomeInProgress) != 0; }

    /// Checks that home is where the motor was when `event` happened.
    void expectCapture(const std::string& event) {
        const int before = truth("position");
        rig->must(event);
        rig->waitTicks(2);
        const int after = truth("position");
        EXPECT_GE(number("home"), before) << event;
        EXPECT_LE(number("home"), after) << event;
        EXPECT_LT(before, after);
        EXPECT_FALSE(searching()) << event;
    }
    void findHome() {
        rig->must("set 1 limit1 1");
        rig->waitTicks(2);
        ASSERT_GT(number("home"), 0);
    }
    /// Checks that a stop bit means nothing on versions 1 and 2.
    void expectNoStop(unsigned bit) {
        for (const char* version : {"servo@1", "servo@2"}) {
            run(version);
            homing(0x01 | bit);
            findHome();
            rig->waitTicks(200);
            EXPECT_EQ(number("command_velocity"), 2) << version;
            EXPECT_EQ(truth("servo_on"), true) << version;
        }
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoHoming, kPlaces, nameOf);

TEST_P(PicServoHoming, SetHomingMode1_Bit0CapturesHomeOnAChangeOfLimit1) {
    homing(0x01);
    rig->must("set 1 limit2 1");
    EXPECT_TRUE(searching());
    expectCapture("set 1 limit1 1");
    homing(0x01);
    expectCapture("set 1 limit1 0");
    expectNoViolation();
}

TEST_P(PicServoHoming, SetHomingMode2_Bit1CapturesHomeOnAChangeOfLimit2) {
    homing(0x02);
    rig->must("set 1 limit1 1");
    EXPECT_TRUE(searching());
    expectCapture("set 1 limit2 1");
    homing(0x02);
    expectCapture("set 1 limit2 0");
}

TEST_P(PicServoHoming, SetHomingMode3_Bit2TurnsTheMotorOffOnHomeFromVersion3On) {
    for (const char* version : {"servo@3", "servo@4"}) {
        run(version);
        homing(0x05);
        EXPECT_EQ(truth("servo_on"), true);
        findHome();
        EXPECT_EQ(truth("servo_on"), false) << version;
        EXPECT_EQ(truth("pwm"), 0);
        EXPECT_EQ(truth("amp_enabled"), true) << "that is left to the host";
    }
}

TEST_P(PicServoHoming, SetHomingMode4_Bit2MeansNothingOnVersions1And2) {
    expectNoStop(0x04);
}

TEST_P(PicServoHoming, SetHomingMode5_Bit3CapturesHomeOnAChangeOfTheIndex) {
    homing(0x08);
    rig->must("set 1 limit1 1");
    rig->must("set 1 limit2 1");
    EXPECT_TRUE(searching());
    // The pin is sampled once a tick, and is high for one count.
    velocity(kOne / 2, kOne);
    ASSERT_LT(number("shaft"), 1500);
    rig->waitTicks(4'000);
    EXPECT_FALSE(searching());
    EXPECT_NEAR(number("home"), 2000, 1) << "a turn after the index where it started";
}

TEST_P(PicServoHoming, SetHomingMode6_Bit4StopsAbruptlyOnHomeFromVersion3On) {
    for (const char* version : {"servo@3", "servo@4"}) {
        run(version);
        homing(0x11);
        findHome();
        EXPECT_EQ(number("command_velocity"), 0) << version;
        EXPECT_EQ(truth("servo_on"), true);
    }
}

TEST_P(PicServoHoming, SetHomingMode7_Bit4MeansNothingOnVersions1And2) {
    expectNoStop(0x10);
}

TEST_P(PicServoHoming, SetHomingMode8_Bit5StopsSmoothlyOnHomeFromVersion3On) {
    for (const char* version : {"servo@3", "servo@4"}) {
        run(version);
        homing(0x21);
        findHome();
        const double v = number("command_velocity");
        EXPECT_GT(v, 1.9) << version;
        EXPECT_LT(v, 2);
        rig->waitTicks(32);
        EXPECT_EQ(number("command_velocity"), v - 1);
        rig->waitTicks(32);
        EXPECT_EQ(number("command_velocity"), 0);
        EXPECT_EQ(truth("servo_on"), true);
    }
}

TEST_P(PicServoHoming, SetHomingMode9_Bit5MeansNothingOnVersions1And2) {
    expectNoStop(0x20);
}

TEST_P(PicServoHoming, SetHomingMode10_Bit6CapturesHomeWhenAnExcessPositionErrorOccurs) {
    const double end = std::ceil(number("shaft")) + 300;
    rig->must("set 1 travel_max " + std::to_string(end));
    homing(0x40);
    EXPECT_TRUE(searching());
    // 150 ticks to the stop, then 250 for an error of 500.
    rig->waitTicks(600);
    EXPECT_FALSE(searching());
    EXPECT_NEAR(number("home"), end, 1);
    EXPECT_EQ(truth("servo_on"), false);
}

TEST_P(PicServoHoming, SetHomingMode11_Bit7CapturesHomeWhenCurrentLimitingOccurs) {
    rig->must("set 1 analog 0");
    gains({.kp = 200, .kd = 2000, .ki = 20, .il = 200, .cl = 101, .el = 500});
    homing(0x80);
    EXPECT_TRUE(searching());
    expectCapture("set 1 analog 200");
}

TEST_P(PicServoHoming, SetHomingMode12_HomeInProgressIsSetByTheCommandAndLoweredWithHome) {
    EXPECT_FALSE(searching());
    EXPECT_EQ(byteAt(command(0x19, {0x03}), 0) & kHomeInProgress, kHomeInProgress);
    rig->must("set 1 limit2 1");
    rig->waitTicks(2);
    EXPECT_FALSE(searching());
}

TEST_P(PicServoHoming, SetHomingMode13_AnyOfTheFlaggedConditionsCapturesAndOnlyTheFirst) {
    homing(0x03);
    expectCapture("set 1 limit2 1");
    const double home = number("home");
    rig->must("set 1 limit1 1");
    rig->waitTicks(2);
    EXPECT_EQ(number("home"), home) << "the search has ended";
    homing(0x03);
    expectCapture("set 1 limit1 0");
}

TEST_P(PicServoHoming, SetHomingMode14_WithoutAStopBitTheMotorGoesOn) {
    homing(0x01);
    findHome();
    rig->waitTicks(200);
    EXPECT_EQ(number("command_velocity"), 2);
}

TEST_P(PicServoHoming, SetHomingMode15_OnlyOneOfBits2And4And5IsSet) {
    homing(0x11);
    expectNoViolation();
    homing(0x31);
    expectViolation("stop_bits");
}

TEST_P(PicServoHoming, SetHomingMode16_ServesAsASafetyShutoffInAnyMotion) {
    stop(kAmplifier | kAbruptly);
    trapezoid(100'000, 2 * kOne, kOne / 32);
    homing(0x07);
    rig->waitTicks(100);
    rig->must("set 1 limit2 1");
    rig->wait(milliseconds(300));
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(number("velocity"), 0);
}

}  // namespace
}  // namespace nmc::conformance
