// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/module/arrival.h"

#include <gtest/gtest.h>

#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

/// A servo with the goal 1000, and a status every 10 ms.
struct Move {
    ArrivalSettings axis{20, 0.1};
    ModuleState module = holdingServo();
    Arrival arrival{};
    int milliseconds = 1'000;

    Arrival::State at(std::int32_t position, bool profileEnded = true) {
        milliseconds += 10;
        const std::uint8_t done = profileEnded ? kMoveDone : 0;
        module.apply(sampleOf(milliseconds / 1'000.0, done | kPosError | kPower, kServoOn, position));
        return arrival.look(module, 1'000, axis);
    }
};

TEST(Arrival, NeedsTheWholeTimeWithinTheTolerance) {
    Move move;
    EXPECT_EQ(move.at(1'000, false), Arrival::State::Underway) << "it only passes by";
    EXPECT_EQ(move.at(1'030), Arrival::State::Underway);
    for (int i = 0; i < 10; ++i)  // 0 to 90 ms
        EXPECT_EQ(move.at(i % 2 == 0 ? 980 : 1'020), Arrival::State::Underway) << i;
    EXPECT_EQ(move.at(1'000), Arrival::State::There);
}

TEST(Arrival, BeginsAnewWhenItLeavesTheTolerance) {
    Move move;
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(move.at(1'000), Arrival::State::Underway);
    EXPECT_EQ(move.at(1'021), Arrival::State::Underway);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(move.at(1'000), Arrival::State::Underway) << i;
    EXPECT_EQ(move.at(1'000), Arrival::State::There);
}

/// It would stand still, but off its goal.
TEST(Arrival, IsMissedTenSecondsAfterTheEndOfTheProfile) {
    Move move;
    for (int i = 0; i <= 1'010; ++i)  // 0 to 10.1 s
        ASSERT_EQ(move.at(950), Arrival::State::Underway) << i;
    EXPECT_EQ(move.at(950), Arrival::State::Missed);
}

TEST(Arrival, WithoutAToleranceIsStandstillWhereverThatIs) {
    Move move;
    move.axis = {};
    EXPECT_EQ(move.at(950), Arrival::State::Underway);
    for (int i = 1; i < 6; ++i)  // to 50 ms
        EXPECT_EQ(move.at(950), Arrival::State::Underway) << i;
    EXPECT_EQ(move.at(950), Arrival::State::There) << "60 ms in one place";
    Move swings;
    swings.axis = {};
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(swings.at(i % 2 == 0 ? 990 : 1'010), Arrival::State::Underway) << i;
}

}  // namespace
}  // namespace nmc
