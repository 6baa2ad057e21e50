// SPDX-License-Identifier: GPL-3.0-or-later
// Units from the numbers on the labels, calculated by hand.
#include "model/settings/drivetrain.h"

#include <gtest/gtest.h>

#include <limits>

namespace nmc {
namespace {

/// 500 lines, four counts each, behind a gear of 50 : 1.
constexpr DriveTrain kGearedServo{2'000, 50, 1, 0};

TEST(DriveTrain, CountsTurnsBehindAGear) {
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {2'000, 1, 1, 0}), 2'000);
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, kGearedServo), 100'000);
    EXPECT_DOUBLE_EQ(countsPerUnit(UnitKind::Degrees, kGearedServo).value(), 100'000 / 360.0);
}

TEST(DriveTrain, CountsMillimetresOfAScrew) {
    // 200 full steps, 8 microsteps, a screw with 5 mm a turn: 320 steps a millimetre.
    EXPECT_EQ(countsPerUnit(UnitKind::Millimetres, {1'600, 1, 1, 5}), 320);
    // The same screw behind a gear of 3 : 2.
    EXPECT_EQ(countsPerUnit(UnitKind::Millimetres, {1'600, 3, 2, 5}), 480);
}

TEST(DriveTrain, TellsNothingWithoutItsNumbers) {
    EXPECT_EQ(countsPerUnit(UnitKind::Millimetres, {1'600, 1, 1, 0}), std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {0, 1, 1, 0}), std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {2'000, 1, 0, 0}), std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {2'000, -1, 1, 0}), std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {1e9, 50, 1, 0}), std::nullopt) << "no such encoder";
    EXPECT_EQ(countsPerUnit(UnitKind::Turns, {std::numeric_limits<double>::quiet_NaN(), 1, 1, 0}),
              std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Native, kGearedServo), std::nullopt);
    EXPECT_EQ(countsPerUnit(UnitKind::Own, kGearedServo), std::nullopt);
}

}  // namespace
}  // namespace nmc
