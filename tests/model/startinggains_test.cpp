// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/startinggains.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

TEST(StartingGains, LimitTheOutputToAQuarterAndTheIntegralToASixteenth) {
    const servo::SetGain gains = startingGains({});
    EXPECT_EQ(gains.ol, 64) << "of 255";
    EXPECT_GT(gains.ki, 0) << "without it friction keeps the motor off its goal";
    EXPECT_LE(gains.ki * gains.il / 256, 16) << "the integral's part of the output, DS-V 4.3";
    EXPECT_EQ(gains.sr, 1);
    EXPECT_TRUE(encode(gains).data.size() == 14) << "every field has a value";
}

TEST(StartingGains, TripAfterAQuarterOfATurn) {
    EXPECT_EQ(startingGains({}).el, 500) << "of 2 000 counts, if nothing is set";
    EXPECT_EQ(startingGains({UnitKind::Turns, 4'000.0, {}}).el, 1'000);
    EXPECT_EQ(startingGains({UnitKind::Degrees, 4'000.0 / 360.0, {}}).el, 1'000);
    EXPECT_EQ(startingGains({UnitKind::Millimetres, 4'000.0, {}}).el, 500)
        << "millimetres do not define a turn";
    EXPECT_EQ(startingGains({UnitKind::Turns, 48.0, {}}).el, 100);
    EXPECT_EQ(startingGains({UnitKind::Turns, 1e9, {}}).el, 2'000) << "a turn behind a gear";
}

TEST(HomeTolerance, FollowsTheAxis) {
    EXPECT_EQ(homeTolerance({}), 1);
    EXPECT_EQ(homeTolerance({UnitKind::Turns, 4'000.0, {}}), 4);
    EXPECT_EQ(homeTolerance({UnitKind::Degrees, 8'000.0 / 360.0, {}}), 8);
    EXPECT_EQ(homeTolerance({UnitKind::Millimetres, 500.0, {}}), 5) << "0.01 mm";
    EXPECT_EQ(homeTolerance({UnitKind::Own, 3'000.0, "µl"}), 3);
    EXPECT_EQ(homeTolerance({UnitKind::Turns, 100.0, {}}), 1) << "the resolution of the encoder";
    EXPECT_EQ(homeTolerance({UnitKind::Turns, 1e9, {}}), 1'000);
}

}  // namespace
}  // namespace nmc
