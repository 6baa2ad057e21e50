// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/axisrange.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

TEST(AxisRange, IsWholeDivisionsAroundTheValues) {
    const AxisRange::Range range = AxisRange::around(-130, 870);
    EXPECT_EQ(range.step, 500);
    EXPECT_EQ(range.min, -500);
    EXPECT_EQ(range.max, 1000);
}

TEST(AxisRange, GrowsAtOnceAndCoversEverything) {
    AxisRange axis;
    axis.fit(0, 100, 0);
    const AxisRange::Range range = axis.fit(-5000, 100, 0.1);
    EXPECT_LE(range.min, -5000);
    EXPECT_GE(range.max, 100);
}

TEST(AxisRange, StaysWhileTheSignalMovesInside) {
    AxisRange axis;
    const AxisRange::Range first = axis.fit(0, 1000, 0);
    for (int i = 1; i < 100; ++i)
        EXPECT_EQ(axis.fit(i, 1000 - i, 0.05 * i), first);
}

TEST(AxisRange, ShrinksOnlyAfterAWhile) {
    AxisRange axis;
    const AxisRange::Range wide = axis.fit(-10000, 10000, 0);
    EXPECT_EQ(axis.fit(0, 10, 1.0), wide);
    EXPECT_EQ(axis.fit(0, 10, 2.5), wide);
    EXPECT_LT(axis.fit(0, 10, 3.5).max, 100);
}

TEST(AxisRange, AValueThatStaysIsInTheMiddle) {
    for (const double value : {0.0, 5.0, -3.0}) {
        const AxisRange::Range range = AxisRange::around(value, value, 0, 4);
        EXPECT_EQ(range.step, 0.5);
        EXPECT_EQ(range.min, value - 1);
        EXPECT_EQ(range.max, value + 1);
    }
}

/// A double at 1e9 has steps of 1e-7.
TEST(AxisRange, IsWideEnoughForTheStepsOfItsNumbers) {
    const AxisRange::Range range = AxisRange::around(1e9, 1e9, 4e-9);
    EXPECT_GE(range.step, 1e-7);
    EXPECT_LT(range.min, 1e9);
    EXPECT_GT(range.max, 1e9);
}

TEST(AxisRange, RestIsNotBlownUpToNoise) {
    const AxisRange::Range range = AxisRange::around(7, 7);
    EXPECT_GE(range.max - range.min, 4);
    EXPECT_GE(range.step, 1);
}

}  // namespace
}  // namespace nmc
