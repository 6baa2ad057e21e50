// SPDX-License-Identifier: GPL-3.0-or-later
// Step metrics against closed forms of first and second order, sampled at awkward times.
#include "model/response/responsemetrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace nmc {
namespace {

using Curve = std::function<double(double seconds)>;  ///< returns 0 before the step, 1 at its goal

constexpr double kPi = 3.14159265358979323846;

/// 1 - exp(-t / tau).
[[nodiscard]] Curve firstOrder(double tau) {
    return [tau](double s) { return s <= 0 ? 0.0 : 1 - std::exp(-s / tau); };
}

/// The response of the textbooks: damping ratio below 1, natural frequency in rad/s.
[[nodiscard]] Curve secondOrder(double damping, double omega) {
    return [=](double s) {
        if (s <= 0)
            return 0.0;
        const double root = std::sqrt(1 - damping * damping);
        return 1 - std::exp(-damping * omega * s) *
                       (std::cos(omega * root * s) + damping / root * std::sin(omega * root * s));
    };
}

/// Samples from shortly before the step on; `phase` is the time of the first sample after it, as a share of
/// the interval.
[[nodiscard]] std::vector<ResponsePoint> sampled(const Curve& curve, double from, double goal,
                                                 double interval, double phase, double length) {
    std::vector<ResponsePoint> points;
    for (double s = interval * (phase - 3); s <= length; s += interval)
        points.push_back({s, from + (goal - from) * curve(s)});
    return points;
}

/// The first time at which the curve is at `level`, by bisection.
[[nodiscard]] double timeOf(const Curve& curve, double level, double notAfter) {
    double low = 0, high = notAfter;
    for (int i = 0; i < 60; ++i)
        (curve((low + high) / 2) < level ? low : high) = (low + high) / 2;
    return low;
}

TEST(ResponseMetrics, OfAFirstOrderResponseAreItsTimeConstants) {
    constexpr double kTau = 0.01;
    for (const double phase : {0.01, 0.3, 0.5, 0.77, 0.99}) {
        const auto points = sampled(firstOrder(kTau), 0, 1'000, 0.001, phase, 0.15);
        const ResponseMetrics m = measureResponse(points, 0, 1'000, 20, 0);
        // A straight line between two samples is off by at most the interval squared / 8 tau.
        ASSERT_TRUE(m.rise && m.overshoot && m.settling && m.steadyError);
        EXPECT_NEAR(m.rise->value, std::log(9.0) * kTau, 1.3e-5) << phase;
        EXPECT_NEAR(m.settling->value, std::log(50.0) * kTau, 1.3e-5) << phase;
        EXPECT_EQ(m.overshoot->value, 0.0);
        // After 12 to 15 time constants, less than e^-12 is left.
        EXPECT_NEAR(m.steadyError->value, 0.0, 1'000 * std::exp(-12.0));
        EXPECT_NEAR(m.interval, 0.001, 1e-9);
    }
}

TEST(ResponseMetrics, OfASecondOrderResponseAreTheTextbooks) {
    constexpr double kOmega = 300;
    for (const double damping : {0.2, 0.4, 0.6}) {
        const Curve curve = secondOrder(damping, kOmega);
        const double overshoot = 100 * std::exp(-kPi * damping / std::sqrt(1 - damping * damping));
        const double peakTime = kPi / (kOmega * std::sqrt(1 - damping * damping));
        const double rise = timeOf(curve, 0.9, peakTime) - timeOf(curve, 0.1, peakTime);
        // The envelope is an upper bound of the settling time; the last crossing is at most half a swing
        // earlier.
        const double envelope = -std::log(0.02 * std::sqrt(1 - damping * damping)) / (damping * kOmega);
        for (const double phase : {0.01, 0.3, 0.5, 0.77, 0.99}) {
            SCOPED_TRACE(testing::Message() << "damping " << damping << ", phase " << phase);
            const auto points = sampled(curve, 500, -300, 0.000'8, phase, 0.3);
            const ResponseMetrics m = measureResponse(points, 500, -300, 16, 0);
            ASSERT_TRUE(m.rise && m.overshoot && m.settling && m.steadyError);
            EXPECT_NEAR(m.overshoot->value, overshoot, 0.1);
            EXPECT_NEAR(m.rise->value, rise, 0.000'1);
            EXPECT_LE(m.settling->value, envelope + 0.000'8);
            EXPECT_GE(m.settling->value, envelope - peakTime - 0.000'8);
            const double last = m.settling->value;
            EXPECT_NEAR(std::abs(curve(last) - 1), 0.02, 0.004)
                << "it is at the edge of the band for the last time";
        }
    }
}

/// A proportional loop with friction stops beside its goal.
TEST(ResponseMetrics, SettleWhereTheyStayAndToTheGoalOrNot) {
    constexpr double kTau = 0.01;
    const auto beside = [](double share) { return [=](double s) { return share * firstOrder(kTau)(s); }; };
    for (const double phase : {0.01, 0.3, 0.5, 0.77, 0.99}) {
        SCOPED_TRACE(phase);
        // The band is 20 of 1000. 990 is within the band: 990 e^-t/tau is 10 at the band around the goal, and
        // 20 at the band around 990.
        const ResponseMetrics close =
            measureResponse(sampled(beside(0.99), 0, 1'000, 0.001, phase, 0.15), 0, 1'000, 20, 0);
        ASSERT_TRUE(close.settling && close.settlingAtRest);
        EXPECT_NEAR(close.settling->value, std::log(99.0) * kTau, 1.3e-5);
        EXPECT_NEAR(close.settlingAtRest->value, std::log(49.5) * kTau, 1.3e-5);
        // 900 is outside the band, but the motor rests there all the same: 900 e^-t/tau is 20.
        const ResponseMetrics far =
            measureResponse(sampled(beside(0.9), 500, -500, 0.001, phase, 0.15), 500, -500, 20, 0);
        EXPECT_EQ(far.settling.error(), Unmeasured::NeverSettled);
        ASSERT_TRUE(far.settlingAtRest);
        EXPECT_NEAR(far.settlingAtRest->value, std::log(45.0) * kTau, 1.3e-5);
        EXPECT_NEAR(far.steadyError->value, -100, 0.01);
    }
    // The motor goes 20 % beyond the goal and sticks at 1050, which it reaches after 20 ms.
    const auto beyond = [](double s) {
        return s <= 0 ? 0.0 : s < 0.01 ? 1.2 : s < 0.02 ? 1.2 - (s - 0.01) * 15 : 1.05;
    };
    const ResponseMetrics over =
        measureResponse(sampled(beyond, 0, 1'000, 0.001, 0.5, 0.15), 0, 1'000, 20, 0);
    EXPECT_EQ(over.settling.error(), Unmeasured::NeverSettled);
    EXPECT_NEAR(over.settlingAtRest->value, 0.01 + 0.13 / 15, 1e-4) << "1070 on the way down";
}

TEST(ResponseMetrics, OfAMotorThatDoesNotMoveHaveNoSettlingTime) {
    const ResponseMetrics m = measureResponse(
        sampled([](double s) { return s > 0 ? 0.01 : 0.0; }, 0, 100, 0.001, 0.5, 0.2), 0, 100, 2, 0);
    EXPECT_EQ(m.settlingAtRest.error(), Unmeasured::NeverRose);
    EXPECT_EQ(m.settling.error(), Unmeasured::NeverSettled);
}

/// 200 responses, settled or not, with intervals of up to a sixth of the rise time.
TEST(ResponseMetrics, DoubtCoversTheTruth) {
    constexpr unsigned kSeed = 4'711;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> uniform(0, 1);
    int risesOutside = 0, overshootsOutside = 0;
    for (int i = 0; i < 200; ++i) {
        const double damping = 0.1 + 0.8 * uniform(random);
        const double omega = 100 + 900 * uniform(random);
        const double interval = (0.05 + 0.3 * uniform(random)) / omega;
        const Curve curve = secondOrder(damping, omega);
        const double peakTime = kPi / (omega * std::sqrt(1 - damping * damping));
        const auto points = sampled(curve, 0, 200, interval, uniform(random), 30 / omega);
        const ResponseMetrics m = measureResponse(points, 0, 200, 4, 0);
        ASSERT_TRUE(m.rise && m.overshoot) << "seed " << kSeed << ", number " << i;
        const double rise = timeOf(curve, 0.9, peakTime) - timeOf(curve, 0.1, peakTime);
        const double overshoot = 100 * std::exp(-kPi * damping / std::sqrt(1 - damping * damping));
        risesOutside += std::abs(m.rise->value - rise) > m.rise->doubt ? 1 : 0;
        overshootsOutside += std::abs(m.overshoot->value - overshoot) > m.overshoot->doubt ? 1 : 0;
    }
    EXPECT_EQ(risesOutside, 0);
    EXPECT_EQ(overshootsOutside, 0);
}

TEST(ResponseMetrics, AreByHandOfTenSamples) {
    // Goal 100, a band of 5 counts. 10 % is half-way from 0 to 20, and 90 % is half-way from 80 to 100.
    const std::vector<ResponsePoint> points = {{-0.001, 0},  {0.001, 20},  {0.002, 50},  {0.003, 80},
                                               {0.004, 100}, {0.005, 110}, {0.006, 100}, {0.007, 94},
                                               {0.008, 98},  {0.009, 99},  {0.010, 99},  {0.011, 97}};
    const ResponseMetrics m = measureResponse(points, 0, 100, 5, 0.000'5);
    EXPECT_NEAR(m.rise->value, 0.003'5 - 0.000'5, 1e-12);
    EXPECT_NEAR(m.rise->doubt, 0.000'5 + 0.000'5 + 0.000'5, 1e-12);
    // A parabola that is equally high on both sides peaks in the middle.
    EXPECT_NEAR(m.overshoot->value, 10, 1e-9);
    EXPECT_NEAR(m.overshoot->doubt, 0.5, 1e-9) << "half a count";
    EXPECT_NEAR(m.settling->value, 0.007 + 0.001 / 4, 1e-12) << "it passes 95 between 94 and 98";
    EXPECT_NEAR(m.settling->doubt, 0.000'5 + 0.000'5, 1e-12);
    // It settles at 98 and a third: 110 is the last sample outside of 93.3 to 103.3, and 100 follows.
    EXPECT_NEAR(m.settlingAtRest->value, 0.005 + 0.001 * (110 - 295.0 / 3 - 5) / 10, 1e-12);
    // The samples from 8.8 ms on are 99, 99 and 97.
    EXPECT_NEAR(m.steadyError->value, 100 - 295.0 / 3, 1e-9);
    EXPECT_NEAR(m.steadyError->doubt, 1, 1e-9);
}

TEST(ResponseMetrics, SettleWhereTheyLeaveTheOtherEdgeOfTheBand) {
    // From 7 above the goal to 3 below it within one interval: it enters the band at +5, a fifth of the way.
    const std::vector<ResponsePoint> points = {{0.001, 60},  {0.002, 107}, {0.003, 97}, {0.004, 100},
                                               {0.005, 100}, {0.006, 100}, {0.007, 100}};
    EXPECT_NEAR(measureResponse(points, 0, 100, 5, 0).settling->value, 0.002'2, 1e-12);
}

TEST(ResponseMetrics, SayWhatCannotBeMeasured) {
    const Curve slow = firstOrder(1);
    const ResponseMetrics never = measureResponse(sampled(slow, 0, 100, 0.001, 0.5, 0.5), 0, 100, 2, 0);
    EXPECT_EQ(never.rise.error(), Unmeasured::NeverRose);
    EXPECT_EQ(never.settling.error(), Unmeasured::NeverSettled);
    EXPECT_EQ(never.overshoot->value, 0.0);

    // It stops 4 counts short and stays there.
    const auto points = sampled([](double s) { return s > 0.01 ? 0.96 : s * 96; }, 0, 100, 0.001, 0.5, 0.2);
    const ResponseMetrics friction = measureResponse(points, 0, 100, 2, 0);
    EXPECT_TRUE(friction.rise);
    EXPECT_EQ(friction.settling.error(), Unmeasured::NeverSettled);
    EXPECT_NEAR(friction.steadyError->value, 4, 1e-9);

    const std::vector<ResponsePoint> few = {{-0.002, 0}, {-0.001, 0}, {0.001, 50}, {0.002, 100}};
    const ResponseMetrics none = measureResponse(few, 0, 100, 2, 0);
    EXPECT_EQ(none.rise.error(), Unmeasured::TooFewSamples);
    EXPECT_EQ(none.overshoot.error(), Unmeasured::TooFewSamples);
    EXPECT_EQ(none.settling.error(), Unmeasured::TooFewSamples);
    EXPECT_EQ(none.steadyError.error(), Unmeasured::TooFewSamples);
    EXPECT_EQ(measureResponse({}, 0, 100, 2, 0).rise.error(), Unmeasured::TooFewSamples);
}

TEST(ResponseMetrics, SayThatSamplesAreMissingWhereItMatters) {
    const Curve curve = secondOrder(0.3, 200);  // it peaks after 16 ms
    const auto without = [&](double from, double to) {
        std::vector<ResponsePoint> points = sampled(curve, 0, 100, 0.001, 0.5, 0.2);
        std::erase_if(points, [=](const ResponsePoint& p) { return p.seconds > from && p.seconds < to; });
        return measureResponse(points, 0, 100, 2, 0);
    };
    const ResponseMetrics whole = without(0, 0);
    const ResponseMetrics late = without(0.12, 0.15);  // it has settled by then
    EXPECT_EQ(late.overshoot->value, whole.overshoot->value);
    EXPECT_EQ(late.settling->value, whole.settling->value);
    const ResponseMetrics peak = without(0.012, 0.022);
    EXPECT_EQ(peak.overshoot.error(), Unmeasured::SamplesMissing);
    EXPECT_EQ(peak.rise->value, whole.rise->value);
    const ResponseMetrics rise = without(0.002, 0.012);  // 10 % after 2.5 ms, 90 % after 8.7 ms
    EXPECT_EQ(rise.rise.error(), Unmeasured::SamplesMissing);
    EXPECT_EQ(without(0.0045, 0.0075).rise->value, whole.rise->value) << "three missing samples are no gap";
}

/// It leaves the band again in the last fifth.
TEST(ResponseMetrics, OfAMotorThatHuntsHaveNoSettlingTime) {
    const auto hunting = [](double s) { return s <= 0 ? 0.0 : 1 + 0.05 * std::sin(200 * s); };
    const ResponseMetrics m = measureResponse(sampled(hunting, 0, 100, 0.001, 0.5, 0.5), 0, 100, 2, 0);
    EXPECT_EQ(m.settling.error(), Unmeasured::NeverSettled);
    EXPECT_EQ(m.settlingAtRest.error(), Unmeasured::NeverSettled);
    EXPECT_NEAR(m.overshoot->value, 5, 0.1);
    EXPECT_NEAR(m.steadyError->value, 0, 0.6);
    EXPECT_NEAR(m.steadyError->doubt, 5, 0.1);
}

}  // namespace
}  // namespace nmc
