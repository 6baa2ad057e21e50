// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the motor with closed forms, because the other tests rely on it.
#include "sim/motorplant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nmc::sim {
namespace {

constexpr double kTickSeconds = 512e-6;

void run(MotorPlant& motor, double seconds, int pwm, bool enabled = true) {
    for (int i = 0; i < static_cast<int>(seconds / kTickSeconds + 0.5); ++i)
        motor.advanceTick(pwm, enabled);
}

TEST(MotorPlant, RunsAtTheNoLoadSpeedOfItsConstants) {
    // Steady state: V = R i + K w and K i = b w + Tc.
    const MotorParameters p;
    for (const int pwm : {255, 128, -255, -40}) {
        MotorPlant motor;
        run(motor, 2.0, pwm);
        const double volts = 24.0 * std::abs(pwm) / 255;
        const double speed = (volts - p.resistanceOhm * p.coulombNm / p.motorConstant) /
                             (p.motorConstant + p.resistanceOhm * p.viscousNmS / p.motorConstant);
        EXPECT_NEAR(motor.speedRadPerSecond(), pwm < 0 ? -speed : speed, 1e-6 * speed) << pwm;
    }
}

TEST(MotorPlant, HasTheMechanicalTimeConstantRJOverKSquared) {
    MotorParameters p;
    p.inductanceHenry = 1e-6;  // R/L 1.1 million per second: the current follows immediately
    p.viscousNmS = 0;
    p.coulombNm = 0;
    MotorPlant motor(p);
    const double tau = p.resistanceOhm * p.inertiaKgM2 / (p.motorConstant * p.motorConstant);
    const double noLoad = 24.0 / p.motorConstant;
    for (int tick = 1; tick <= 100; ++tick) {
        motor.advanceTick(255, true);
        const double expected = noLoad * (1.0 - std::exp(-tick * kTickSeconds / tau));
        ASSERT_NEAR(motor.speedRadPerSecond(), expected, 1e-3 * noLoad) << tick;
    }
}

TEST(MotorPlant, TravelsTheIntegralOfItsSpeed) {
    MotorParameters p;
    p.inductanceHenry = 1e-6;
    p.viscousNmS = 0;
    p.coulombNm = 0;
    MotorPlant motor(p);
    run(motor, 1000 * kTickSeconds, 255);
    const double tau = p.resistanceOhm * p.inertiaKgM2 / (p.motorConstant * p.motorConstant);
    const double t = 1000 * kTickSeconds;
    const double radians = 24.0 / p.motorConstant * (t - tau * (1.0 - std::exp(-t / tau)));
    EXPECT_NEAR(motor.shaftCounts(), radians * 2000 / (2 * std::numbers::pi), 1.0);
}

TEST(MotorPlant, DrawsTheStallCurrentWhenHeld) {
    MotorParameters p;
    p.travelMaxCounts = 0;
    MotorPlant motor(p);
    run(motor, 0.1, 255);
    EXPECT_NEAR(motor.currentAmperes(), 24.0 / 1.1, 1e-6);
    EXPECT_EQ(motor.speedRadPerSecond(), 0.0);
    EXPECT_EQ(motor.currentSense(), 255);  // 21.8 A at 1 V/A: more than the converter's 5 V.
}

TEST(MotorPlant, ItsCurrentRisesWithTheElectricalTimeConstantAtStandstill) {
    MotorParameters p;
    p.coulombNm = 10;  // stronger than the motor
    MotorPlant motor(p);
    for (int tick = 1; tick <= 8; ++tick) {
        motor.advanceTick(51, true);  // a fifth of 24 V
        const double expected = 4.8 / 1.1 * (1.0 - std::exp(-tick * kTickSeconds * 1.1 / 0.6e-3));
        ASSERT_NEAR(motor.currentAmperes(), expected, 1e-9);
        ASSERT_EQ(motor.currentSense(), static_cast<int>(expected * 51)) << "1 V per ampere, 255 = 5 V";
    }
    EXPECT_EQ(motor.shaftCounts(), 0.0);
}

TEST(MotorPlant, DryFrictionAloneStopsACoastingMotorAtAConstantRate) {
    MotorParameters p;
    p.viscousNmS = 0;
    MotorPlant motor(p);
    run(motor, 1.0, 255);
    const double begin = motor.speedRadPerSecond();
    const double from = motor.shaftCounts();
    const double deceleration = p.coulombNm / p.inertiaKgM2;
    run(motor, 200 * kTickSeconds, 0, false);
    EXPECT_NEAR(motor.speedRadPerSecond(), begin - deceleration * 200 * kTickSeconds, 1e-6 * begin);
    EXPECT_EQ(motor.currentAmperes(), 0.0);
    run(motor, begin / deceleration, 0, false);
    EXPECT_TRUE(motor.atRest());
    // v^2/2a, in counts of 2 pi / 2000.
    EXPECT_NEAR(motor.shaftCounts() - from,
                begin * begin / (2 * deceleration) * 2000 / (2 * std::numbers::pi), 1.0);
}

TEST(MotorPlant, ViscousFrictionSlowsACoastingMotorExponentially) {
    MotorParameters p;
    p.viscousNmS = 1e-4;
    p.coulombNm = 0;
    MotorPlant motor(p);
    run(motor, 1.0, 255);
    const double begin = motor.speedRadPerSecond();
    run(motor, 300 * kTickSeconds, 0, false);
    const double expected = begin * std::exp(-300 * kTickSeconds * p.viscousNmS / p.inertiaKgM2);
    EXPECT_NEAR(motor.speedRadPerSecond(), expected, 1e-6 * begin);
}

TEST(MotorPlant, AShortedMotorBrakesMuchFasterThanAnOpenOne) {
    MotorPlant shorted;
    MotorPlant open;
    run(shorted, 1.0, 255);
    run(open, 1.0, 255);
    run(shorted, 0.04, 0, true);  // three time constants of 13 ms
    run(open, 0.04, 0, false);
    EXPECT_LT(shorted.speedRadPerSecond(), 0.1 * open.speedRadPerSecond());
}

TEST(MotorPlant, StaysAtRestWhileTheTorqueIsBelowFriction) {
    const MotorParameters p;
    // K V / R at standstill: 0.004 N·m needs 0.1158 V, that is 1.23 PWM counts.
    MotorPlant held;
    run(held, 1.0, 1);
    EXPECT_EQ(held.shaftCounts(), 0.0);
    EXPECT_NEAR(held.currentAmperes(), 24.0 / 255 / p.resistanceOhm, 1e-9);
    MotorPlant moved;
    run(moved, 1.0, 2);
    EXPECT_GT(moved.shaftCounts(), 0.0);
}

TEST(MotorPlant, ALoadBelowFrictionIsHeldAndALargerOneTurnsTheShaftBackwards) {
    MotorParameters p;
    p.loadNm = 0.0039;
    MotorPlant held(p);
    run(held, 1.0, 0, false);
    EXPECT_EQ(held.shaftCounts(), 0.0);
    EXPECT_TRUE(held.atRest());

    p.loadNm = 0.005;
    p.viscousNmS = 0;
    MotorPlant moved(p);
    run(moved, 100 * kTickSeconds, 0, false);
    EXPECT_NEAR(moved.speedRadPerSecond(), -(0.005 - 0.004) / p.inertiaKgM2 * 100 * kTickSeconds, 1e-6);
}

TEST(MotorPlant, ReversesThroughStandstillWithoutGainingEnergy) {
    MotorPlant motor;
    run(motor, 1.0, 255);
    double last = motor.speedRadPerSecond();
    for (int i = 0; i < 400; ++i) {
        motor.advanceTick(-255, true);
        ASSERT_LE(motor.speedRadPerSecond(), last + 1e-9);
        last = motor.speedRadPerSecond();
    }
    EXPECT_LT(last, -600.0);
}

TEST(MotorPlant, StopsAtTheEndsOfItsTravel) {
    MotorParameters p;
    p.travelMinCounts = -300;
    p.travelMaxCounts = 500;
    MotorPlant motor(p);
    run(motor, 0.2, 255);
    EXPECT_EQ(motor.shaft(), 500);
    EXPECT_EQ(motor.speedRadPerSecond(), 0.0);
    run(motor, 0.2, -255);
    EXPECT_EQ(motor.shaft(), -300);
    EXPECT_EQ(motor.shaftCounts(), -300.0);
}

TEST(MotorPlant, AnAmplifierWithADeadbandGivesNothingBelowIt) {
    MotorParameters p;
    p.amplifierDeadbandPwm = 20;
    MotorPlant motor(p);
    run(motor, 0.5, 20);
    EXPECT_EQ(motor.currentAmperes(), 0.0);
    EXPECT_EQ(motor.shaftCounts(), 0.0);
    run(motor, 0.5, 30);
    EXPECT_GT(motor.shaftCounts(), 0.0);
}

TEST(MotorPlant, TheIndexIsHighForOneCountInATurn) {
    MotorPlant motor;
    EXPECT_TRUE(motor.index(motor.shaft()));
    int high = 0;
    std::int64_t lastHigh = 0;
    for (int i = 0; i < 20000; ++i) {
        motor.advanceTick(-3, true);  // slower than a count per tick
        if (motor.index(motor.shaft()) && motor.shaft() != lastHigh) {
            ++high;
            lastHigh = motor.shaft();
            EXPECT_EQ(motor.shaft() % 2000, 0);
        }
    }
    EXPECT_EQ(high, -motor.shaft() / 2000);
    EXPECT_GT(high, 2);
}

}  // namespace
}  // namespace nmc::sim
