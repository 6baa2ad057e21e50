// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/intent/moveforecast.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

constexpr double kTicksPerSecond = 1953.125;

TEST(MoveForecast, ATrapezoidReachesItsVelocity) {
    // 20 000 counts at 8 counts/tick and 0.02 counts/tick^2: 20000/8 + 8/0.02 = 2900 ticks.
    const MoveForecast move = forecast(20'000, 8.0, 0.02, kTicksPerSecond);
    EXPECT_FALSE(move.triangular);
    EXPECT_DOUBLE_EQ(move.peakVelocity, 8.0);
    EXPECT_DOUBLE_EQ(move.seconds, 2900 / kTicksPerSecond);
}

TEST(MoveForecast, AShortMoveIsATriangle) {
    // 800 counts at 0.02 counts/tick^2: peak sqrt(800 x 0.02) = 4, 2 x 4 / 0.02 = 400 ticks.
    const MoveForecast move = forecast(-800, 8.0, 0.02, kTicksPerSecond);
    EXPECT_TRUE(move.triangular);
    EXPECT_DOUBLE_EQ(move.peakVelocity, 4.0);
    EXPECT_DOUBLE_EQ(move.seconds, 400 / kTicksPerSecond);
}

TEST(MoveForecast, BothFormulasMeetAtTheEdge) {
    // v^2 / a = 3200 counts.
    EXPECT_FALSE(forecast(3200, 8.0, 0.02, 1.0).triangular);
    EXPECT_DOUBLE_EQ(forecast(3200, 8.0, 0.02, 1.0).seconds, 800.0);
    EXPECT_NEAR(forecast(3199.999, 8.0, 0.02, 1.0).seconds, 800.0, 0.001);
}

TEST(MoveForecast, NoWayTakesNoTime) {
    EXPECT_EQ(forecast(0, 8.0, 0.02, kTicksPerSecond).seconds, 0.0);
}

}  // namespace
}  // namespace nmc
