// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that real motors have and `set` gives to the simulated one, each compared with a closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "sim/control.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::seconds;

// The default motor: R b / (k^2 + R b) of the speed is lost to viscous friction.
constexpr double kViscous = 0.038 * 0.038 / (0.038 * 0.038 + 1.1 * 1e-6);

class Motors : public testing::Test {
protected:
    Motors() {
        wire.address(1);
        wire.enableAmplifier();
    }
    nlohmann::json say(const std::string& line) {
        return nlohmann::json::parse(handleControlLine(wire.chain, line, wire.now, {}));
    }
    void set(const std::string& nameAndValue) {
        EXPECT_EQ(say("set 1 " + nameAndValue), nlohmann::json({{"ok", true}})) << nameAndValue;
    }
    double state(const char* key) { return say("state 1")[key].get<double>(); }
    /// The speed that it reaches at a PWM value, in counts per second.
    double speedAt(int pwm) {
        wire.pwm(pwm);
        wire.wait(seconds(2));
        return state("velocity") / 512e-6;
    }

    HostWire wire;
};

TEST_F(Motors, HaveTheGainInCountsPerSecondForAPwmCount) {
    // 24 V / 255 / 0.038 V s * 2000 / 2 pi.
    EXPECT_NEAR(state("gain"), 788.4, 0.1);
    set("friction 0");
    EXPECT_NEAR(speedAt(100), 100 * 788.4 * kViscous, 10);
    set("gain 300");
    EXPECT_NEAR(speedAt(100), 100 * 300 * kViscous, 1);
    EXPECT_NEAR(speedAt(-20), -20 * 300 * kViscous, 1);
    // A friction torque M reduces the speed by M R / k^2 rad/s.
    set("friction 0.002");
    EXPECT_NEAR(speedAt(100),
                kViscous * (30'000 - 0.002 * 1.1 / (0.038 * 0.038) * 2'000 / (2 * std::numbers::pi)), 1);
}

TEST_F(Motors, HaveTheirCountsPerTurn) {
    set("friction 0");
    set("counts_per_turn 500");
    EXPECT_NEAR(speedAt(100), 100 * 788.4 / 4 * kViscous, 3);
    // The index comes once in 500 counts.
    wire.pwm(0);
    wire.wait(seconds(1));
    wire.pwm(1);  // 197 counts per second: a tenth of a count per tick
    int turns = 0;
    bool before = true;
    const double from = state("shaft");
    for (int tick = 0; tick < 50'000; ++tick) {
        wire.waitTicks(1);
        const bool now = wire.truth().servo.index;
        turns += now && !before ? 1 : 0;
        before = now;
    }
    EXPECT_NEAR(turns, (state("shaft") - from) / 500, 1);
    EXPECT_GT(turns, 5);
}

TEST_F(Motors, TurnTheirEncoderBehindThePlay) {
    set("play 30");
    wire.pwm(50);
    wire.wait(seconds(1));
    wire.pwm(0);
    wire.wait(seconds(1));
    const auto forward = say("state 1");
    EXPECT_EQ(forward["position"].get<double>(), std::floor(forward["shaft"].get<double>()) - 30);
    wire.pwm(-50);
    wire.wait(seconds(1));
    const auto reverse = say("state 1");
    EXPECT_EQ(reverse["position"].get<double>(), std::floor(reverse["shaft"].get<double>()));
}

TEST_F(Motors, HaveAnAmplifierWithADeadband) {
    set("friction 0");
    set("deadband 55");
    EXPECT_EQ(speedAt(55), 0.0);
    // (155 - 55) / (255 - 55): half of 24 V.
    EXPECT_NEAR(speedAt(155), 0.5 * 255 * 788.4 * kViscous, 10);
    EXPECT_NEAR(speedAt(255), 255 * 788.4 * kViscous, 20) << "full output as before";
}

TEST_F(Motors, HaveAnEncoderWithNoise) {
    const auto noiseOf = [](HostWire& one, unsigned module) {
        std::vector<double> off;
        for (int i = 0; i < 4'000; ++i) {
            one.waitTicks(1);
            off.push_back(one.truth(module).servo.position);
        }
        return off;
    };
    HostWire two("servo,servo");
    for (const unsigned module : {1U, 2U})
        two.set(Input::EncoderNoise, 3.0, module);
    const std::vector<double> off = noiseOf(two, 1);
    double mean = 0;
    for (const double value : off)
        mean += value / 4'000;
    double variance = 0;
    for (const double value : off)
        variance += (value - mean) * (value - mean) / 4'000;
    // Whole counts of a normal distribution: variance 3^2 + 1/12. Four standard deviations of mean and
    // variance.
    EXPECT_NEAR(mean, 0.0, 4 * 3.014 / std::sqrt(4'000));
    EXPECT_NEAR(variance, 9.083, 4 * 9.083 * std::sqrt(2.0 / 4'000));
    EXPECT_EQ(two.truth(1).servo.shaftCounts, 0.0) << "the shaft is at rest";
    EXPECT_NE(noiseOf(two, 2), off);
    HostWire again("servo,servo");
    again.set(Input::EncoderNoise, 3.0, 1);
    EXPECT_EQ(noiseOf(again, 1), off) << "one seed, one history";
    again.set(Input::EncoderNoise, 0.0, 1);
    again.waitTicks(1);
    EXPECT_EQ(again.truth(1).servo.position, 0) << "the noise leaves no offset";
}

// ---- A second mass on a spring ----

TEST(ElasticLoad, SwingsAgainstTheShaftAtItsResonance) {
    // The second mass is at rest when it is attached to a shaft that coasts at w0 without friction: w0 J1 /
    // (J1 + J2) remains, and the rest is the damped swing of J1 J2 / (J1 + J2) on the spring, which begins
    // with a speed of w0 and a twist of 0.
    for (const double hertz : {20.0, 50.0, 400.0})
        for (const double share : {0.2, 1.0, 5.0}) {
            MotorParameters p;
            p.viscousNmS = 0;
            p.coulombNm = 0;
            MotorPlant motor(p);
            for (int tick = 0; tick < 2'000; ++tick)
                motor.advanceTick(50, true);
            const double begin = motor.speedRadPerSecond();
            p.elasticInertiaKgM2 = share * p.inertiaKgM2;
            p.resonanceHz = hertz;
            motor.setParameters(p);
            const double omega = 2 * std::numbers::pi * hertz;
            constexpr double kZeta = 0.02;
            const double root = std::sqrt(1 - kZeta * kZeta);
            for (int tick = 1; tick * 512e-6 < 2.5 / hertz; ++tick) {
                motor.advanceTick(0, false);
                const double t = tick * 512e-6;
                const double swing = std::exp(-kZeta * omega * t) *
                                     (std::cos(root * omega * t) - kZeta / root * std::sin(root * omega * t));
                const double expected = begin * (1 + share * swing) / (1 + share);
                // Leapfrog integration is too fast by (omega 128 us)^2 / 24, which is 0.4 % at 400 Hz,
                // over 2.5 turns of 2 pi.
                ASSERT_NEAR(motor.speedRadPerSecond(), expected, (hertz > 100 ? 0.08 : 0.01) * begin)
                    << hertz << " Hz, " << share << ", " << t << " s";
            }
        }
}

TEST(ElasticLoad, ComesToRestAtAShaftThatFrictionHolds) {
    MotorParameters p;
    p.elasticInertiaKgM2 = 1e-5;
    p.resonanceHz = 30;
    MotorPlant motor(p);
    for (int tick = 0; tick < 2'000; ++tick)
        motor.advanceTick(100, true);
    for (int tick = 0; tick < 20'000; ++tick)
        motor.advanceTick(0, true);
    EXPECT_TRUE(motor.atRest());
    const double shaft = motor.shaftCounts();
    motor.advanceTick(0, true);
    EXPECT_EQ(motor.shaftCounts(), shaft);
}

TEST_F(Motors, CarryASecondMassOnASpring) {
    set("friction 0");
    static_cast<void>(speedAt(50));
    wire.command(1, 0x17, {0x02});  // AMP_EN low: it coasts
    const double begin = state("velocity") / 512e-6;
    set("resonance 40");
    set("elastic_inertia 1.7e-5");  // as much as the rotor's
    wire.waitTicks(24);             // half of 25 ms: all of the speed has been passed on
    EXPECT_NEAR(state("velocity") / 512e-6, 0.0, 0.1 * begin);
    wire.wait(seconds(1));
    EXPECT_NEAR(state("velocity") / 512e-6, 0.5 * begin, 0.05 * begin)
        << "momentum is conserved, and shared after a while";
    EXPECT_EQ(state("elastic_inertia"), 1.7e-5);
    EXPECT_EQ(state("resonance"), 40.0);
}

}  // namespace
}  // namespace nmc::sim::test
