// SPDX-License-Identifier: GPL-3.0-or-later
// Commands as bytes: the simulator's behaviour beyond the statements of DS-V 5.2 and 4.5, which
// tests/conformance covers.
#include "protocol/baud.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;

class Servo : public testing::Test {
protected:
    Servo() {
        wire.address(1);
        wire.enableAmplifier();
    }
    void servoOn() {
        wire.gains(goodGains());
        wire.servoOn();
        wire.command(1, 0x0B);
    }
    HostWire wire;
};

TEST(ServoPowerUp, EstablishesTheStateOfTheDataSheet) {
    HostWire wire;
    // Type, version, home, aux, velocity, A/D, position: everything that can be requested.
    EXPECT_EQ(wire.command(0, 0x13, {0x3F}), (Bytes{0x19, 0, 0, 0, 0, 0, 0, 0, 0x00, 0, 0, 0, 0, 0, 4, 0x1D}))
        << "move_done, power, pos_error set; aux clear (the shaft is at its index)";
    const ModuleSnapshot s = wire.truth();
    EXPECT_EQ(s.address, 0);
    EXPECT_EQ(s.group, 0xFF);
    EXPECT_FALSE(s.leader);
    EXPECT_EQ(s.baud, realRate(63));
    EXPECT_FALSE(s.servo.ampEnabled);
    EXPECT_EQ(s.servo.mode, ServoMode::Pwm);
    EXPECT_EQ(s.servo.pwm, 0);
    EXPECT_EQ(s.servo.gains.sr, 1);
    EXPECT_EQ(s.servo.gains.kp, 0);
}

TEST_F(Servo, TheIdleReplyHasTheShapeOfTheGoldenOne) {
    // 11 22 25 00 00 4F 00 00 18 E0 05 00 00 A4 of a real module: status, position, A/D, velocity, aux, home,
    // sum.
    wire.pwm(60);
    wire.wait(milliseconds(100));
    wire.command(1, 0x0C);
    wire.pwm(0);
    wire.wait(milliseconds(500));
    wire.set(Input::Analog, 0x4F);
    const Bytes reply = wire.command(1, 0x13, {0x1F});
    ASSERT_EQ(reply.size(), 14U);
    EXPECT_EQ(reply[0], 0x19);
    EXPECT_EQ(reply[5], 0x4F);
    unsigned sum = 0;
    for (std::size_t i = 0; i < 13; ++i)
        sum += reply[i];
    EXPECT_EQ(reply[13], sum & 0xFFU);
    const Report r = wire.report();
    EXPECT_EQ(r.position, wire.truth().servo.position);
    EXPECT_EQ(r.home, wire.truth().servo.home);
    EXPECT_GT(r.position, r.home);
    EXPECT_GT(r.home, 0);
}

TEST_F(Servo, VelocityModeFollowsTheVelocityAndReportsItsNegative) {
    servoOn();
    wire.velocity(-5 * std::int64_t{kOne}, kOne / 10);
    EXPECT_FALSE(wire.report().moveDone()) << "accelerating";
    wire.waitTicks(300);
    const Report r = wire.report();
    EXPECT_TRUE(r.moveDone()) << "the command velocity has been reached";
    EXPECT_NEAR(r.velocityItem, 5, 1);
    EXPECT_NEAR(wire.truth().servo.velocity, -5.0, 0.5);
    EXPECT_EQ(wire.truth().servo.mode, ServoMode::Velocity);
}

TEST_F(Servo, StartMotionWithNothingLoadedDoesNothing) {
    servoOn();
    wire.command(1, 0x05);
    EXPECT_TRUE(wire.report().servoOn());
    EXPECT_EQ(wire.truth().servo.mode, ServoMode::Velocity);
    wire.pwm(40);
    wire.command(1, 0x05);
    EXPECT_EQ(wire.truth().servo.pwm, 40) << "the load that was executed at once is the last one";
    wire.command(1, 0x0F);
    wire.wait(milliseconds(10));
    wire.address(1);
    servoOn();
    wire.command(1, 0x05);
    EXPECT_TRUE(wire.report().servoOn()) << "a reset forgets it";
    EXPECT_TRUE(wire.violations().empty());
}

TEST_F(Servo, EnteringVelocityModeFromACoastingMotorKeepsItsVelocity) {
    wire.gains(goodGains());
    wire.pwm(50);
    wire.waitTicks(300);
    const double before = wire.truth().servo.velocity;
    ASSERT_GT(before, 10);
    wire.velocity(static_cast<std::int64_t>(before) * kOne, kOne / 100);
    for (int i = 0; i < 20; ++i) {
        wire.waitTicks(1);
        ASSERT_NEAR(wire.truth().servo.commandVelocity, before, 1.1);
        ASSERT_NEAR(wire.truth().servo.velocity, before, 0.25 * before)
            << "the filter has to build up its output";
    }
    EXPECT_FALSE(wire.truth().servo.mode == ServoMode::Pwm);
    EXPECT_LT(std::abs(wire.truth().servo.positionError), 60);
}

TEST_F(Servo, PwmModeDrivesTheAmplifierDirectlyInBothDirections) {
    wire.gains(gainData(0, 0, 0, 0, 10, 0, 0, 1, 7));
    wire.pwm(80);
    EXPECT_EQ(wire.truth().servo.pwm, 80) << "neither output limit nor deadband compensation";
    wire.waitTicks(200);
    EXPECT_GT(wire.report().position, 100);
    EXPECT_LT(wire.report().velocityItem, 0);
    wire.pwm(-80);
    EXPECT_EQ(wire.truth().servo.pwm, -80);
    EXPECT_FALSE(wire.report().servoOn());
}

TEST_F(Servo, Bit0OfStopAloneOnlySetsTheAmplifier) {
    servoOn();
    wire.velocity(2 * kOne, kOne);
    wire.waitTicks(50);
    wire.command(1, 0x17, {0x01});
    EXPECT_TRUE(wire.truth().servo.ampEnabled);
    EXPECT_EQ(wire.truth().servo.commandVelocity, 2.0);
    wire.command(1, 0x17, {0x00});
    EXPECT_FALSE(wire.truth().servo.ampEnabled);
    EXPECT_TRUE(wire.truth().servo.servoOn);
}

TEST_F(Servo, MotorOffDisablesTheServoAndSetsPositionErrorForGood) {
    servoOn();
    EXPECT_FALSE(wire.report().positionError());
    wire.command(1, 0x17, {0x03});
    Report r = wire.report();
    EXPECT_FALSE(r.servoOn());
    EXPECT_TRUE(r.positionError());
    EXPECT_TRUE(r.moveDone());
    EXPECT_EQ(wire.truth().servo.pwm, 0);
    wire.command(1, 0x0B);
    EXPECT_TRUE(wire.report().positionError()) << "set whenever the servo is off";
    wire.servoOn();
    EXPECT_TRUE(wire.report().positionError()) << "sticky";
    wire.command(1, 0x0B);
    EXPECT_FALSE(wire.report().positionError());
}

TEST_F(Servo, AnUnusedCommandCodeIsAnsweredAndChangesNothing) {
    EXPECT_EQ(wire.command(1, 0x0D).size(), 2U);
    EXPECT_EQ(wire.violations(), std::vector{ViolationKind::UnknownCommand});
}

}  // namespace
}  // namespace nmc::sim::test
