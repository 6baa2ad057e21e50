// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/profilecurve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace nmc {
namespace {

TEST(ProfileCurve, ATrapezoidTakesDistanceOverVelocityPlusVelocityOverAcceleration) {
    // 1000 counts at 100 counts/s and 50 counts/s^2: ramps of 2 s and 100 counts each, and 800 counts in 8 s
    // at full velocity.
    const auto curve = ProfileCurve::trapezoid(0, 1'000, 100, 50);
    EXPECT_DOUBLE_EQ(curve.duration(), 12.0);
    EXPECT_DOUBLE_EQ(curve.position(1.0), 25.0);
    EXPECT_DOUBLE_EQ(curve.position(2.0), 100.0);
    EXPECT_DOUBLE_EQ(curve.position(6.0), 500.0);
    EXPECT_DOUBLE_EQ(curve.velocity(6.0), 100.0);
    EXPECT_DOUBLE_EQ(curve.position(11.0), 975.0);
    EXPECT_DOUBLE_EQ(curve.velocity(11.0), 50.0);
    EXPECT_DOUBLE_EQ(curve.position(12.0), 1'000.0);
    EXPECT_DOUBLE_EQ(curve.position(99.0), 1'000.0);
    EXPECT_DOUBLE_EQ(curve.velocity(99.0), 0.0);
}

TEST(ProfileCurve, AShortMoveIsTriangularWithItsPeakAtTheMiddle) {
    // 100 counts at 4 counts/s^2: a peak of sqrt(100 * 4) = 20 after 5 s, 10 s in all.
    const auto curve = ProfileCurve::trapezoid(50, -50, 1'000, 4);
    EXPECT_DOUBLE_EQ(curve.duration(), 10.0);
    EXPECT_DOUBLE_EQ(curve.position(5.0), 0.0);
    EXPECT_DOUBLE_EQ(curve.velocity(5.0), -20.0);
    EXPECT_DOUBLE_EQ(curve.position(10.0), -50.0);
}

TEST(ProfileCurve, AVelocityChangeRampsThroughZeroAndGoesOn) {
    const auto curve = ProfileCurve::velocityChange(0, 30, -30, 10);
    EXPECT_DOUBLE_EQ(curve.duration(), 6.0);
    EXPECT_DOUBLE_EQ(curve.position(3.0), 45.0);
    EXPECT_DOUBLE_EQ(curve.position(6.0), 0.0);
    EXPECT_DOUBLE_EQ(curve.position(8.0), -60.0);
    EXPECT_DOUBLE_EQ(curve.velocity(8.0), -30.0);
}

TEST(ProfileCurve, WithoutAccelerationNothingChanges) {
    EXPECT_DOUBLE_EQ(ProfileCurve::velocityChange(5, 2, 9, 0).position(10), 25.0);
    EXPECT_DOUBLE_EQ(ProfileCurve::trapezoid(5, 9, 0, 1).position(10), 5.0);
    EXPECT_DOUBLE_EQ(ProfileCurve::trapezoid(5, 5, 1, 1).position(10), 5.0);
}

TEST(ProfileCurve, AStretchedCurveVisitsTheSamePlacesLater) {
    const auto curve = ProfileCurve::trapezoid(0, 1'000, 100, 50);
    const auto slow = curve.stretched(3.0);
    for (const double s : {0.5, 2.0, 6.0, 11.5, 12.0})
        EXPECT_NEAR(slow.position(3.0 * s), curve.position(s), 1e-9);
    EXPECT_NEAR(slow.velocity(18.0), curve.velocity(6.0) / 3.0, 1e-12);
}

RC_GTEST_PROP(ProfileCurve, NeverExceedsItsVelocityAndAccelerationAndEndsAtItsGoal, ()) {
    const double goal = *rc::gen::inRange(-1'000'000, 1'000'000);
    const double velocity = *rc::gen::inRange(1, 100'000);
    const double acceleration = *rc::gen::inRange(1, 1'000'000);
    const auto curve = ProfileCurve::trapezoid(0, goal, velocity, acceleration);
    RC_ASSERT(curve.position(curve.duration() + 1e-9) == goal);
    const double dt = curve.duration() / 500;
    RC_PRE(dt > 0.0);
    for (int i = 0; i < 500; ++i) {
        const double dp = curve.position((i + 1) * dt) - curve.position(i * dt);
        RC_ASSERT(std::abs(dp) <= velocity * dt * (1 + 1e-6) + 1e-6);
        const double dv = curve.velocity((i + 1) * dt) - curve.velocity(i * dt);
        RC_ASSERT(std::abs(dv) <= acceleration * dt * (1 + 1e-6) + 1e-6);
    }
}

}  // namespace
}  // namespace nmc
