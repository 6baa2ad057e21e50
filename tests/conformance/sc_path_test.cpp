// SPDX-License-Identifier: GPL-3.0-or-later
// PIC-SERVO SC and CMC: Add Path Points.
#include "tests/conformance/scservo.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Course = std::vector<double>;

/// The command position after each tick of a path: `segments` in counts, each lasting `ticks`.
Course course(const std::vector<int>& segments, int ticks) {
    Course places;
    double from = 0;
    for (const int counts : segments) {
        for (int tick = 1; tick <= ticks; ++tick)
            places.push_back(from + static_cast<double>(counts) * tick / ticks);
        from += counts;
    }
    return places;
}

TEST_P(ScServo, AddPathPoints1_WithoutPointsItStartsThePath) {
    servoOn();
    points({0x0102, 0x0102});
    rig->wait(milliseconds(100));
    EXPECT_EQ(truth("path_mode"), false);
    EXPECT_EQ(truth("command_position"), 0.0);
    command(0x0D);
    EXPECT_EQ(truth("path_mode"), true);
    expectNoViolation();
}

// Each magnitude results in whole multiples of 1/64 count per tick, which are exact in a double.

TEST_P(ScServo, AddPathPoints2_At30HzTheWordIsTheMagnitudeTimes4WithF) {
    servoOn();
    points({64 * 4 | 2, 32 * 4 | 2});
    EXPECT_EQ(followPath(128), course({64, 32}, 64));
}

TEST_P(ScServo, AddPathPoints3_At60HzTheMagnitudeTimes8) {
    servoOn();
    points({32 * 8, 96 * 8});
    EXPECT_EQ(followPath(64), course({32, 96}, 32));
}

TEST_P(ScServo, AddPathPoints4_OnTheFastPathAt60HzTheMagnitudeTimes8WithF) {
    servoOn();
    ioControl(kFastPath);
    points({32 * 8 | 2, 64 * 8 | 2});
    EXPECT_EQ(followPath(64), course({32, 64}, 32));
}

TEST_P(ScServo, AddPathPoints5_OnTheFastPathAt120HzTheMagnitudeTimes16) {
    servoOn();
    ioControl(kFastPath);
    points({16 * 16, 48 * 16});
    EXPECT_EQ(followPath(32), course({16, 48}, 16));
}

TEST_P(ScServo, AddPathPoints6_Bit0IsReverse) {
    servoOn();
    points({32 * 8 | 1, 64 * 8, 96 * 8 | 1});
    EXPECT_EQ(followPath(96), course({-32, 64, -96}, 32));
}

TEST_P(ScServo, AddPathPoints7_EachSegmentEndsExactlyOnItsPoint) {
    servoOn();
    // Odd counts, at both rates in turn: 100 in 32 ticks, 77 in 64, -3 in 32 and 501 in 32; the maximum at 60
    // Hz, 8191, is too fast for this motor.
    points({100 * 8, 77 * 4 | 2, 3 * 8 | 1, 501 * 8});
    const Course places = followPath(32 + 64 + 32 + 32);
    EXPECT_EQ(places.at(31), 100);
    EXPECT_EQ(places.at(31 + 64), 177);
    EXPECT_EQ(places.at(31 + 64 + 32), 174);
    EXPECT_EQ(places.at(31 + 64 + 32 + 32), 675);
    EXPECT_EQ(places.at(32), 100 + 77.0 / 64);
}

TEST_P(ScServo, AddPathPoints8_AnScHolds128Points) {
    for (int i = 0; i < 18; ++i)
        points({8, 8, 8, 8, 8, 8, 8});
    points({8, 8});
    EXPECT_EQ(pathPoints(), 128U);
    expectNoViolation();
    points({8});
    EXPECT_EQ(pathPoints(), 128U);
    expectViolation("path_overflow");
}

TEST_P(ScServo, AddPathPoints9_ACmcHolds96) {
    start("servo@5", 1);
    stop(0x20);
    for (int i = 0; i < 16; ++i)
        points({8, 8, 8, 8, 8, 8});
    EXPECT_EQ(pathPoints(), 96U);
    points({8});
    EXPECT_EQ(pathPoints(), 96U);
    expectViolation("path_overflow");
}

TEST_P(ScServo, AddPathPoints10_ThePathEndsAtTheLastPointWhenTheBufferRunsDry) {
    servoOn();
    points({160 * 8, 160 * 8});
    command(0x0D);
    rig->wait(milliseconds(500));
    EXPECT_EQ(truth("command_position"), 320.0);
    EXPECT_EQ(truth("command_velocity"), 0.0);
    EXPECT_EQ(truth("path_mode"), false);
    EXPECT_EQ(truth("servo_on"), true);
    EXPECT_EQ(status().byte & kMoveDone, kMoveDone);
}

TEST_P(ScServo, AddPathPoints11_AnyStopMotorEndsIt) {
    load(kLoadAcceleration | kStart, little(kOne, 4));  // for the smooth stop
    load(kLoadAcceleration, little(0, 4));              // waits for Start Motion
    for (const unsigned control :
         {kAmplifier, kAmplifier | kMotorOff, kAmplifier | kAbruptly, kAmplifier | kSmoothly}) {
        servoOn();
        points({32 * 8, 32 * 8, 32 * 8, 32 * 8, 32 * 8, 32 * 8, 32 * 8});
        command(0x0D);
        ASSERT_EQ(truth("path_mode"), true);
        stop(control);
        EXPECT_EQ(truth("path_mode"), false) << control;
        EXPECT_EQ(pathPoints(), 0U) << control;
        rig->wait(milliseconds(500));
        EXPECT_EQ(status().byte & kMoveDone, kMoveDone) << control;
    }
}

TEST_P(ScServo, AddPathPoints12_PointsMayBeAddedUnderWay) {
    servoOn();
    points({160 * 8, 160 * 8});
    command(0x0D);
    points({160 * 8 | 1, 32 * 8});
    rig->wait(milliseconds(500));
    EXPECT_EQ(truth("command_position"), 192.0);
}

TEST_P(ScServo, AddPathPoints13_AGroupStartsTogether) {
    start("servo@10,servo@10", 0);
    for (const unsigned address : {1U, 2U}) {
        command(0x21, {static_cast<std::uint8_t>(address), 0x81}, 0);
        servoOn(kGoodGains, address);
        points({320 * 8, 320 * 8, 320 * 8, 320 * 8}, address);
    }
    rig->exchange({0xAA, 0x81, 0x0D, 0x8E});
    rig->wait(milliseconds(20));
    const double first = rig->state(1)["command_position"];
    const double second = rig->state(2)["command_position"];
    EXPECT_GT(first, 100);
    // 10 counts per tick; the ticks of the two modules are up to one apart.
    EXPECT_NEAR(first, second, 10);
}

TEST_P(ScServo, AddPathPoints14_TheSheetsSampleIsFourPointsOfMinus100ToMinus103) {
    servoOn();
    rig->exchange({0xAA, 0x01, 0x8D, 0x21, 0x03, 0x29, 0x03, 0x31, 0x03, 0x39, 0x03, 0x4E});
    EXPECT_EQ(pathPoints(), 4U);
    const Course places = followPath(4 * 32);
    EXPECT_EQ(places.at(31), -100);
    EXPECT_EQ(places.at(63), -201);
    EXPECT_EQ(places.at(95), -303);
    EXPECT_EQ(places.at(127), -406);
}

TEST_P(ScServo, AddPathPoints15_OlderChipsHaveNoSuchCommand) {
    start("servo@4", 1);
    points({8});
    expectViolation("unknown_command");
}

TEST_P(ScServo, AddPathPoints16_MotionFollowsThePath) {
    servoOn();
    points({320 * 8, 320 * 8, 320 * 8, 320 * 8, 320 * 8});
    command(0x0D);
    rig->wait(seconds(1));
    EXPECT_NEAR(number("position"), 1600, 3);
}

}  // namespace
}  // namespace nmc::conformance
