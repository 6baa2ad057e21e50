// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/axisscale.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

TEST(AxisScale, TheChipsOwnUnitChangesNothing) {
    const AxisScale scale = AxisScale::servo({}, 1);
    EXPECT_EQ(scale.position(1234.0), 1234.0);
    EXPECT_EQ(scale.velocity(0.25), 0.25);
    EXPECT_EQ(scale.acceleration(0.002), 0.002);
}

TEST(AxisScale, TurnsOfAnEncoderPerSecond) {
    // 2000 counts a turn; a tick is 0.512 ms, so 1 count/tick is 1953.125 counts/s = 0.9765625 turns/s.
    const AxisScale scale = AxisScale::servo({UnitKind::Turns, 2000.0, {}}, 1);
    EXPECT_DOUBLE_EQ(scale.position(500.0), 0.25);
    EXPECT_DOUBLE_EQ(scale.counts(0.25), 500.0);
    EXPECT_DOUBLE_EQ(*scale.velocity(1.0), 0.9765625);
    EXPECT_DOUBLE_EQ(*scale.nativeVelocity(0.9765625), 1.0);
    // 1 count/tick^2 is 1953.125^2 / 2000 turns/s^2.
    EXPECT_DOUBLE_EQ(*scale.acceleration(1.0), 1907.3486328125);
    EXPECT_DOUBLE_EQ(*scale.nativeAcceleration(1907.3486328125), 1.0);
}

TEST(AxisScale, TheServoRateStretchesTheTick) {
    // SR 10: 195.3125 ticks/s (DS-V 4.3).
    const AxisScale scale = AxisScale::servo({UnitKind::Degrees, 10.0, {}}, 10);
    EXPECT_DOUBLE_EQ(*scale.perSecond(), 195.3125);
    EXPECT_DOUBLE_EQ(*scale.velocity(1.0), 19.53125);
    EXPECT_NEAR(*scale.acceleration(1.0), 3814.697265625, 1e-9);
}

/// Positions change their sign; amounts, which have no direction, stay the same.
TEST(AxisScale, AReversedAxisTurnsPositionsRoundAndNoAmount) {
    const AxisScale scale = AxisScale::servo({UnitKind::Turns, -2000.0, {}}, 1);
    EXPECT_TRUE(scale.reversed());
    EXPECT_DOUBLE_EQ(scale.position(500.0), -0.25);
    EXPECT_DOUBLE_EQ(scale.counts(0.25), -500.0);
    EXPECT_DOUBLE_EQ(scale.distance(500.0), 0.25);
    EXPECT_DOUBLE_EQ(scale.countsOfDistance(0.25), 500.0);
    EXPECT_DOUBLE_EQ(*scale.velocity(1.0), 0.9765625);
    EXPECT_DOUBLE_EQ(*scale.nativeAcceleration(1907.3486328125), 1.0);
    EXPECT_EQ(*countsPerTurn(scale.unit()), 2000.0);
    EXPECT_EQ(homeTolerance(scale.unit()), 2);
    EXPECT_FALSE(AxisScale::servo({}, 1).reversed());
}

/// Another host may have set SR: a count per tick may be 1953 counts/s or 7.7, which cannot be found out.
TEST(AxisScale, NothingPerSecondIsKnownWhileTheServoRateIsNot) {
    const AxisScale counts = AxisScale::servo({}, std::nullopt);
    EXPECT_FALSE(counts.perSecond());
    EXPECT_TRUE(counts.timed()) << "counts per tick is the chip's own unit";
    EXPECT_EQ(counts.velocity(0.25), 0.25);
    const AxisScale turns = AxisScale::servo({UnitKind::Turns, 2000.0, {}}, std::nullopt);
    EXPECT_FALSE(turns.timed());
    EXPECT_DOUBLE_EQ(turns.position(500.0), 0.25);
    EXPECT_FALSE(turns.velocity(1.0));
    EXPECT_FALSE(turns.nativeVelocity(1.0));
    EXPECT_FALSE(turns.acceleration(1.0));
    EXPECT_FALSE(turns.nativeAcceleration(1.0));
}

TEST(AxisScale, AStepperCountsInSecondsAnyway) {
    const AxisScale scale = AxisScale::step({UnitKind::Millimetres, 80.0, {}});
    EXPECT_TRUE(scale.steps());
    EXPECT_DOUBLE_EQ(*scale.velocity(1600.0), 20.0);
    EXPECT_DOUBLE_EQ(*scale.nativeAcceleration(2.5), 200.0);
}

}  // namespace
}  // namespace nmc
