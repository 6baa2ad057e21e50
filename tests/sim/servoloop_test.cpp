// SPDX-License-Identifier: GPL-3.0-or-later
// The closed loop (DS-V 4.2, 4.3) and its figures.
#include "sim/servoloop.h"

#include <cmath>

#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;

TEST(PidFilter, ComputesTheSumOfThreeTermsInIntegers) {
    Gains g;
    g.kp = 100;
    g.kd = 1000;
    g.ki = 50;
    g.il = 2;
    PidFilter f;
    // The running sum is 300; divided by 256, this is 1.
    EXPECT_EQ(f.output(g, 300), 100 * 300 + 1000 * 300 + 50 * 1);
    // The sum is held at 2 * 256.
    EXPECT_EQ(f.output(g, 290), 100 * 290 - 1000 * 10 + 50 * 2);
    EXPECT_EQ(f.output(g, -600), -100 * 600 - 1000 * 890 + 0) << "512 - 600 = -88, less than one 256th";
    g.il = 0;
    f.output(g, 500);
    g.il = 2;
    EXPECT_EQ(f.output(g, 0), -1000 * 500) << "an integration limit of 0 has emptied the sum";
}

TEST(Encoder, ExtendsItsSixteenBitCounterTo32Bits) {
    Encoder e;
    for (std::int64_t shaft = 0; shaft <= 100'000; shaft += 250)
        e.read(shaft);
    EXPECT_EQ(e.position(), 100'000);
    for (std::int64_t shaft = 100'000; shaft >= -100'000; shaft -= 250)
        e.read(shaft);
    EXPECT_EQ(e.position(), -100'000);
    EXPECT_FALSE(e.wrapped());
}

TEST(Encoder, LosesEdgesBeyond500000PerSecond) {
    Encoder e;
    e.read(1000);  // in one tick of 512 us
    EXPECT_EQ(e.position(), 256);
    e.read(1100);
    EXPECT_EQ(e.position(), 356);
}

TEST(ServoLoop, TurnsItsEncoderBehindThePlay) {
    MotorParameters motor;
    motor.playCounts = 30;
    ServoLoop loop(4);
    loop.setMotor(motor);
    loop.reset();
    loop.setAmplifier(true);
    Trajectory drive;
    drive.control = Trajectory::kPwm;
    drive.pwm = 100;
    loop.load(drive);
    loop.start();
    loop.run(400);
    const double farthest = loop.snapshot().shaftCounts;
    ASSERT_GT(farthest, 1'000);
    EXPECT_EQ(loop.position(), static_cast<std::int32_t>(farthest) - 30);
    drive.control = Trajectory::kPwm | Trajectory::kReverse;
    loop.load(drive);
    loop.start();
    loop.run(2'000);
    ASSERT_LT(loop.snapshot().shaftCounts, farthest - 1'000);
    EXPECT_EQ(loop.position(), static_cast<std::int32_t>(std::floor(loop.snapshot().shaftCounts)));
}

/// The index belongs to the encoder, and the switch at LIMIT1 to the load.
TEST(ServoLoop, PutsTheIndexAtTheEncoderAndTheHomeSwitchBehindTheLoadsPlay) {
    MotorParameters motor;
    motor.playCounts = 30;
    motor.loadPlayCounts = 50;
    ServoLoop loop(4);
    loop.setMotor(motor);
    loop.reset();
    loop.set(Input::HomeSwitchAt, 300.0);
    loop.setAmplifier(true);
    const auto drive = [&](bool reverse) {
        Trajectory pwm;
        pwm.control = static_cast<std::uint8_t>(Trajectory::kPwm | (reverse ? Trajectory::kReverse : 0));
        pwm.pwm = 3;  // slower than a count per tick
        loop.load(pwm);
        loop.start();
    };
    // Runs until the level changes; returns the encoder's position there.
    const auto change = [&](bool ServoSnapshot::*pin) {
        const bool before = loop.snapshot().*pin;
        for (int tick = 0; tick < 60'000 && loop.snapshot().*pin == before; ++tick)
            loop.run(1);
        EXPECT_NE(loop.snapshot().*pin, before);
        return loop.position();
    };
    drive(false);
    EXPECT_EQ(change(&ServoSnapshot::index), 1);
    EXPECT_EQ(change(&ServoSnapshot::limit1), 350);
    EXPECT_NEAR(loop.snapshot().shaftCounts, 380.5, 0.5);
    EXPECT_EQ(change(&ServoSnapshot::index), 2'000);
    drive(true);
    EXPECT_EQ(change(&ServoSnapshot::limit1), 299);
    EXPECT_FALSE(loop.snapshot().limit2) << "only LIMIT1 has the switch";
    loop.set(Input::HomeSwitchAt, std::nullopt);
    loop.set(Input::Limit1, 1.0);
    EXPECT_TRUE(loop.snapshot().limit1) << "set by hand again";
}

TEST(Encoder, SaysWhenThe32BitCounterWraps) {
    Encoder e;
    std::int64_t shaft = 0;
    while (shaft < 2'147'483'647 - 300)
        e.read(shaft += 256);
    EXPECT_FALSE(e.wrapped());
    for (int i = 0; i < 3; ++i)
        e.read(shaft += 256);
    EXPECT_TRUE(e.wrapped());
    EXPECT_EQ(e.position(), static_cast<std::int32_t>(static_cast<std::uint32_t>(shaft)));
    e.clearWrapped();
    e.read(shaft + 1);
    EXPECT_FALSE(e.wrapped());
}

struct StepResponse {
    double rise1090 = 0;  ///< ms, from 10 % to 90 %
    double rise90 = 0;    ///< ms, from the first tick of the move to 90 %
    double overshoot = 0;
    double final = 0;
};

/// A move of 200 counts with the largest velocity and acceleration, which jumps (DS-V 4.3).
StepResponse step(const Bytes& gains) {
    constexpr double kGoal = 200;
    HostWire wire;
    wire.address(1);
    wire.gains(gains);
    wire.servoOn();
    wire.waitTicks(20);
    Bytes data{0x97};
    for (const std::uint32_t value : {200U, 0x7FFFFFFFU, 0x7FFFFFFFU})
        append(data, value, 4);
    wire.chain.hostSends(packet(1, 0xD4, data), wire.now);
    while (wire.truth().servo.commandPosition == 0)
        wire.now += std::chrono::microseconds(64);
    StepResponse r;
    double before = 0;
    double t10 = 0;
    double peak = 0;
    const auto crossing = [&before](int tick, double now, double level) {
        return (tick - 1 + (level - before) / (now - before)) * 0.512;
    };
    for (int tick = 1; tick < 3000; ++tick) {
        wire.now += kTick;
        const double now = wire.truth().servo.shaftCounts;
        if (before < 0.1 * kGoal && now >= 0.1 * kGoal && t10 == 0)
            t10 = crossing(tick, now, 0.1 * kGoal);
        if (before < 0.9 * kGoal && now >= 0.9 * kGoal && r.rise90 == 0)
            r.rise90 = crossing(tick, now, 0.9 * kGoal);
        peak = std::max(peak, now);
        before = now;
    }
    r.rise1090 = r.rise90 - t10;
    r.overshoot = peak / kGoal - 1;
    r.final = before;
    return r;
}

TEST(StepResponse, IsFastAndDampedWithGoodGains) {
    const StepResponse r = step(goodGains());
    EXPECT_NEAR(r.rise90, 11.0, 0.5);
    EXPECT_NEAR(r.rise1090, 8.7, 0.5);
    EXPECT_NEAR(r.overshoot, 0.02, 0.01);
    EXPECT_NEAR(r.final, 200, 3);
}

TEST(StepResponse, OvershootsByHalfWithoutDamping) {
    EXPECT_NEAR(step(gainData(100, 0, 0, 0, 255, 0, 0x3FFF, 1, 0)).overshoot, 0.5, 0.05);
}

class Loop : public testing::Test {
protected:
    Loop() { wire.address(1); }
    /// Blocks the shaft at position 0.
    void block() {
        wire.set(Input::TravelMin, 0);
        wire.set(Input::TravelMax, 0);
    }
    HostWire wire;
};

TEST_F(Loop, ThePwmIsTheOutputOver256WithTheOutputLimit) {
    block();
    wire.gains(gainData(256, 0, 0, 0, 255, 0, 0x3FFF, 1, 0));
    wire.servoOn();
    wire.command(1, 0x57, {0x11, 100, 0, 0, 0});
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, 100);
    wire.command(1, 0x57, {0x11, 0x9C, 0xFF, 0xFF, 0xFF});
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, -100);
    wire.gains(gainData(256, 0, 0, 0, 60, 0, 0x3FFF, 1, 0));
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, -60);
}

TEST_F(Loop, DeadbandCompensationIsAddedToANonZeroOutput) {
    block();
    wire.gains(gainData(256, 0, 0, 0, 255, 0, 0x3FFF, 1, 30));
    wire.servoOn();
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, 0);
    wire.command(1, 0x57, {0x11, 2, 0, 0, 0});
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, 32);
    wire.command(1, 0x57, {0x11, 0xFE, 0xFF, 0xFF, 0xFF});
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, -32);
    wire.command(1, 0x57, {0x11, 250, 0, 0, 0});
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.pwm, 255);
}

TEST_F(Loop, TheIntegralTakesTheErrorAwayThatALoadMakes) {
    wire.gains(gainData(200, 2000, 0, 0, 255, 0, 0x3FFF, 1, 0));
    wire.servoOn();
    wire.set(Input::Load, 0.02);
    wire.wait(milliseconds(2000));
    EXPECT_LT(wire.report().position, -3);
    wire.gains(gainData(200, 2000, 200, 2000, 255, 0, 0x3FFF, 1, 0));
    wire.wait(milliseconds(4000));
    EXPECT_NEAR(wire.report().position, 0, 2);
}

TEST_F(Loop, AnErrorBeyondTheLimitDisablesTheServo) {
    block();
    wire.gains(gainData(100, 0, 0, 0, 255, 0, 50, 1, 0));
    wire.servoOn();
    wire.command(1, 0x0B);
    wire.command(1, 0x57, {0x11, 50, 0, 0, 0});
    wire.waitTicks(5);
    EXPECT_FALSE(wire.report().positionError()) << "the error must be larger than the limit, not equal to it";
    wire.command(1, 0x57, {0x11, 51, 0, 0, 0});
    wire.waitTicks(5);
    const Report r = wire.report();
    EXPECT_TRUE(r.positionError());
    EXPECT_FALSE(r.servoOn());
    EXPECT_TRUE(r.moveDone());
    EXPECT_EQ(wire.truth().servo.pwm, 0);
    EXPECT_EQ(wire.truth().servo.commandPosition, 0) << "it follows the motor";
}

TEST_F(Loop, CurrentLimitingTakesOneCountPerTickWhileOverAndGivesItBack) {
    block();
    wire.set(Input::Analog, 0);
    wire.gains(gainData(256, 0, 0, 0, 255, 101, 0x3FFF, 1, 0));
    wire.servoOn();
    wire.command(1, 0x57, {0x11, 100, 0, 0, 0});
    wire.waitTicks(10);
    EXPECT_FALSE(wire.report().overcurrent());
    wire.set(Input::Analog, 101);
    wire.waitTicks(10);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 0) << "the current must exceed the limit";
    wire.set(Input::Analog, 102);
    wire.waitTicks(30);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 30);
    EXPECT_EQ(wire.truth().servo.pwm, 70);
    wire.waitTicks(200);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 100) << "it is at most the output";
    wire.set(Input::Analog, 50);
    wire.waitTicks(40);
    EXPECT_EQ(wire.truth().servo.pwm, 40);
    wire.waitTicks(200);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 0);
    EXPECT_TRUE(wire.report().overcurrent()) << "sticky";
    wire.command(1, 0x0B);
    EXPECT_FALSE(wire.report().overcurrent());
}

TEST_F(Loop, AnEvenCurrentLimitIsALowerBoundAndZeroIsNone) {
    block();
    wire.set(Input::Analog, 99);
    wire.gains(gainData(256, 0, 0, 0, 255, 0, 0x3FFF, 1, 0));
    wire.servoOn();
    wire.command(1, 0x57, {0x11, 100, 0, 0, 0});
    wire.waitTicks(10);
    EXPECT_FALSE(wire.report().overcurrent());
    wire.gains(gainData(256, 0, 0, 0, 255, 100, 0x3FFF, 1, 0));
    wire.waitTicks(10);
    EXPECT_TRUE(wire.report().overcurrent());
    wire.set(Input::Analog, 100);
    wire.waitTicks(200);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 0);
}

TEST_F(Loop, TheCurrentLimitHoldsAStalledMotorNearIt) {
    block();
    wire.gains(gainData(256, 0, 0, 0, 255, 101, 0x3FFF, 1, 0));  // 2 A
    wire.servoOn();
    wire.command(1, 0x57, {0x11, 250, 0, 0, 0});
    wire.wait(milliseconds(300));
    EXPECT_NEAR(wire.truth().servo.amperes, 101 / 51.0, 0.2);
}

TEST_F(Loop, TheServoRateDivisorSlowsProfileAndReportedVelocityButNotCurrentLimiting) {
    block();
    wire.set(Input::Analog, 200);
    wire.gains(gainData(256, 0, 0, 0, 255, 101, 0x3FFF, 10, 0));
    wire.servoOn();
    wire.velocity(kOne, kOne);
    wire.waitTicks(1);
    const double from = wire.truth().servo.commandPosition;
    wire.waitTicks(200);
    EXPECT_NEAR(wire.truth().servo.commandPosition - from, 20, 1) << "a count per ten ticks";
    wire.set(Input::Analog, 0);
    wire.waitTicks(100);
    wire.set(Input::Analog, 200);
    wire.waitTicks(5);
    EXPECT_EQ(wire.truth().servo.currentLimitAdjustment, 5);
}

TEST_F(Loop, AtALowServoRateTheVelocityItemCountsPerServoTick) {
    wire.enableAmplifier();
    wire.pwm(40);
    wire.wait(milliseconds(300));
    const double perTick = wire.truth().servo.velocity;
    EXPECT_NEAR(-wire.report().velocityItem, perTick, 1);
    wire.gains(gainData(0, 0, 0, 0, 0, 0, 0, 20, 0));
    wire.waitTicks(60);
    EXPECT_NEAR(-wire.report().velocityItem, 20 * perTick, 3);
}

TEST_F(Loop, WhileTheServoIsOffTheCommandFollowsTheMotor) {
    wire.enableAmplifier();
    wire.pwm(60);
    wire.wait(milliseconds(300));
    const ServoSnapshot s = wire.truth().servo;
    EXPECT_EQ(s.commandPosition, s.position);
    EXPECT_NEAR(s.commandVelocity, s.velocity, 1);
    EXPECT_EQ(s.positionError, 0);
}

TEST_F(Loop, AMotorHitByALoadReturns) {
    wire.gains(goodGains());
    wire.servoOn();
    wire.waitTicks(100);
    wire.set(Input::Load, 0.05);
    wire.waitTicks(40);
    EXPECT_LT(wire.truth().servo.shaftCounts, -2);
    wire.set(Input::Load, 0.0);
    wire.wait(milliseconds(500));
    EXPECT_NEAR(wire.truth().servo.shaftCounts, 0, 3);
}

}  // namespace
}  // namespace nmc::sim::test
