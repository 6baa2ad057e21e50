// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/module/measuredspeed.h"

#include <gtest/gtest.h>

#include "scopesamples.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using testing_support::atMs;

/// Applies a status reply every 10 ms.
void turn(MeasuredSpeed& speed, int from, int to, double countsPerSecond, std::int32_t begin = 0) {
    for (int ms = from; ms <= to; ms += 10)
        speed.apply(atMs(ms), begin + static_cast<std::int32_t>(countsPerSecond * (ms - from) / 1e3));
}

TEST(MeasuredSpeed, IsUnknownUntilItWasLookedAtForLongEnough) {
    MeasuredSpeed speed;
    EXPECT_EQ(speed.perSecond(), std::nullopt);
    turn(speed, 0, 40, 5'000);
    EXPECT_EQ(speed.perSecond(), std::nullopt);
    turn(speed, 50, 50, 0, 250);
    EXPECT_EQ(speed.perSecond(), 5'000);
}

TEST(MeasuredSpeed, FollowsTheShaftWithinAFifthOfASecond) {
    MeasuredSpeed speed;
    turn(speed, 0, 1'000, 5'000);
    EXPECT_NEAR(*speed.perSecond(), 5'000, 1e-6);
    turn(speed, 1'010, 1'210, -300, 5'000);
    EXPECT_NEAR(*speed.perSecond(), -300, 1e-6);
}

TEST(MeasuredSpeed, IsNothingForAShaftThatIsHeldBetweenTwoCounts) {
    MeasuredSpeed speed;
    for (int ms = 0; ms < 500; ms += 10) {
        speed.apply(atMs(ms), ms / 10 % 2);
        EXPECT_EQ(speed.perSecond().value_or(0), 0) << ms;
    }
}

TEST(MeasuredSpeed, GoesOnWhereTheCounterWraps) {
    MeasuredSpeed speed;
    speed.apply(atMs(0), 2'147'483'600);
    speed.apply(atMs(100), -2'147'483'596);  // 100 counts further
    EXPECT_EQ(speed.perSecond(), 1'000);
}

TEST(MeasuredSpeed, KnowsNothingWhenTheCounterWasSet) {
    MeasuredSpeed speed;
    turn(speed, 0, 1'000, 5'000);
    speed.apply({ModuleIndex(0), atMs(1'001), ServoCommand(ResetPosition{})});
    EXPECT_EQ(speed.perSecond(), std::nullopt);
    turn(speed, 1'010, 1'100, 5'000);
    EXPECT_NEAR(*speed.perSecond(), 5'000, 1e-6);
}

TEST(MeasuredSpeed, KnowsNothingAfterASilence) {
    MeasuredSpeed speed;
    turn(speed, 0, 1'000, 5'000);
    turn(speed, 2'010, 2'010, 0, 90'000);
    EXPECT_EQ(speed.perSecond(), std::nullopt);
}

}  // namespace
}  // namespace nmc
