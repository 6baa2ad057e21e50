// SPDX-License-Identifier: GPL-3.0-or-later
// Margins against closed forms, predicted steps against the simulator's motor.
#include "model/tuning/predict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/tunedservo.h"

namespace nmc {
namespace {

[[nodiscard]] servo::SetGain gainsOf(std::uint16_t kp, std::uint16_t kd) {
    return {kp, kd, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};
}

TEST(LoopMargins, AreThoseOfTheContinuousLoopFarBelowTheServoRate) {
    // L = K Kp / 256 / (s (tau s + 1)) is 1 at w = 10 rad/s if K Kp / 256 = 10 sqrt(1 + (10 tau)^2): 11.18
    // with tau 0.05 s. There the phase is -90 - atan(0.5) = -116.57 degrees, and half a tick of holding -0.15
    // more.
    const MotorConstants motor{256 * 11.180'34 / 100, 0.05, 3, 1, 0};
    const LoopMargins margins = marginsOf(motor, gainsOf(100, 0));
    EXPECT_TRUE(margins.stable);
    EXPECT_NEAR(margins.crossover, 10 / (2 * std::numbers::pi), 0.01);
    EXPECT_NEAR(margins.phaseDegrees, 63.43 - 0.15, 0.1);
}

TEST(LoopMargins, CountTheDelay) {
    // As above; 1 ms at 10 rad/s is 0.57 degrees.
    const MotorConstants motor{256 * 11.180'34 / 100, 0.05, 3, 1, 1e-3};
    EXPECT_NEAR(marginsOf(motor, gainsOf(100, 0)).phaseDegrees, 63.43 - 0.15 - 0.57, 0.1);
}

TEST(LoopMargins, EndWhereAMotorWithoutInertiaIsSteppedTooFar) {
    // x is x - K T Kp / 256 x a tick later: stable up to 2, which is Kp = 512 / (1000 x 0.512 ms) = 1000.
    const MotorConstants motor{1'000, 1e-7, 0, 0, 0};
    EXPECT_TRUE(marginsOf(motor, gainsOf(990, 0)).stable);
    EXPECT_FALSE(marginsOf(motor, gainsOf(1'010, 0)).stable);
    EXPECT_NEAR(marginsOf(motor, gainsOf(500, 0)).gain, 2.0, 0.01);
}

/// The margin is read from the frequency response, stability from the poles.
TEST(LoopMargins, SayHowMuchHigherAllGainsCouldBe) {
    const MotorConstants motor{788, 0.013, 2, 0, 0.55e-3};
    for (const std::uint16_t ki : {std::uint16_t{0}, std::uint16_t{200}}) {
        servo::SetGain gains = gainsOf(200, 2'000);
        gains.ki = ki;
        gains.il = 100;
        const double margin = marginsOf(motor, gains).gain;
        ASSERT_TRUE(std::isfinite(margin));
        const auto times = [&gains](double factor) {
            servo::SetGain more = gains;
            more.kp = static_cast<std::uint16_t>(gains.kp * factor);
            more.kd = static_cast<std::uint16_t>(gains.kd * factor);
            more.ki = static_cast<std::uint16_t>(gains.ki * factor);
            return more;
        };
        EXPECT_TRUE(marginsOf(motor, times(margin * 0.97)).stable) << margin;
        EXPECT_FALSE(marginsOf(motor, times(margin * 1.03)).stable) << margin;
    }
}

TEST(Predict, LeavesWhatFrictionHoldsAtRest) {
    // Without an integral, friction of 4 PWM counts and one that is cut off hold Kp e / 256 up to 5: 12.8
    // counts with Kp 100.
    const MotorConstants motor{788, 0.013, 4, 0, 0.5e-3};
    const Prediction prediction = predict(motor, gainsOf(100, 1'000), 1'000, 1'200, 1, 2);
    EXPECT_EQ(prediction.run.taken.from, 1'000);
    EXPECT_EQ(prediction.run.points.front().position, 1'000);
    EXPECT_GT(std::abs(prediction.errorAtRest), 1);
    EXPECT_LE(std::abs(prediction.errorAtRest), 13);
    servo::SetGain integrating = gainsOf(100, 1'000);
    integrating.ki = 80;
    integrating.il = 50;
    EXPECT_LE(std::abs(predict(motor, integrating, 1'000, 1'200, 3, 2).errorAtRest), 1);
}

TEST(Predict, SeesTheSimulatorsMotorOvershootAndSettle) {
    sim::MotorParameters motor;
    for (const auto& gains : {gainsOf(200, 2'000), gainsOf(200, 500), gainsOf(600, 3'000)}) {
        const Prediction prediction = predict(testing_support::physics(motor), gains, 0, 300, 0.4, 2);
        testing_support::TunedServo servo(motor, gains, 3);
        servo.wait(0.1);
        const ResponseRecord run = servo.step(300, 0.4);
        ASSERT_TRUE(run.metrics.overshoot && run.metrics.settling);
        ASSERT_TRUE(prediction.run.metrics.overshoot && prediction.run.metrics.settling);
        EXPECT_NEAR(prediction.run.metrics.overshoot->value, run.metrics.overshoot->value, 5);
        EXPECT_NEAR(prediction.run.metrics.rise->value, run.metrics.rise->value,
                    0.1 * run.metrics.rise->value + run.metrics.rise->doubt);
    }
}

}  // namespace
}  // namespace nmc
