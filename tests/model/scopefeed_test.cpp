// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/scopefeed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr std::uint8_t kHolds = kMoveDone | kPower;

TEST(ScopeFeed, GivesNothingOfAStatusWithoutPosition) {
    ScopeFeed feed;
    bus::Sample sample = sampleOf(0, kHolds, kServoOn);
    sample.report.position.reset();
    EXPECT_FALSE(feed.take(sample).has_value());
}

TEST(ScopeFeed, VelocityIsTheWayOfTheLast20Milliseconds) {
    ScopeFeed feed;
    // 2 ms apart, 3 counts each: 1500 counts/s.
    for (int i = 0; i <= 20; ++i) {
        const auto sample = feed.take(sampleOf(i * 0.002, kHolds, kServoOn, 3 * i));
        ASSERT_TRUE(sample.has_value());
        if (i < 10)
            EXPECT_TRUE(std::isnan(sample->velocity)) << i;
        else
            EXPECT_NEAR(sample->velocity, 1'500, 0.01) << i;
    }
}

TEST(ScopeFeed, WherePollsAreRareVelocityIsTheWayOfOnePoll) {
    ScopeFeed feed;
    static_cast<void>(feed.take(sampleOf(0, kHolds, kServoOn, 0)));
    static_cast<void>(feed.take(sampleOf(1, kHolds, kServoOn, 100)));
    EXPECT_NEAR(feed.take(sampleOf(2, kHolds, kServoOn, 300))->velocity, 200, 0.001);
}

TEST(ScopeFeed, DataIsMissingAfterThreeUsualIntervals) {
    ScopeFeed feed;
    double time = 0;
    const auto next = [&](double interval) {
        time += interval;
        return feed.take(sampleOf(time, kHolds, kServoOn, 0))->gapBefore;
    };
    EXPECT_TRUE(next(0)) << "the first has nothing before it";
    for (int i = 0; i < 50; ++i)
        EXPECT_FALSE(next(0.01));
    EXPECT_FALSE(next(0.045)) << "a busy moment: 3 x 10 ms + 20 ms";
    for (int i = 0; i < 50; ++i)
        EXPECT_FALSE(next(0.01));
    EXPECT_TRUE(next(0.1));
    for (int i = 0; i < 50; ++i)
        EXPECT_FALSE(next(0.1)) << "that is the usual interval now";
}

TEST(ScopeFeed, APositionThatGoesRoundIsAGapAndNoVelocity) {
    ScopeFeed feed;
    constexpr std::int32_t kTop = std::numeric_limits<std::int32_t>::max();
    for (int i = 0; i < 20; ++i)
        static_cast<void>(feed.take(sampleOf(i * 0.01, kHolds, kServoOn, kTop)));
    const auto round = feed.take(sampleOf(0.2, kHolds, kServoOn, std::numeric_limits<std::int32_t>::min()));
    EXPECT_TRUE(round->gapBefore);
    EXPECT_TRUE(std::isnan(round->velocity));
}

/// The shaft stands at 100 000 while the counter is set to 0, from here or by another host.
TEST(ScopeFeed, ACounterThatIsSetIsAGapAndNoVelocity) {
    for (const bool fromHere : {true, false}) {
        ScopeFeed feed;
        for (int i = 0; i <= 20; ++i)
            static_cast<void>(feed.take(sampleOf(i * 0.01, kHolds, kServoOn, 100'000)));
        if (fromHere)
            feed.apply(executedAt(0.205, ResetPosition{}));
        for (int i = 0; i < 10; ++i) {
            bus::Sample sample = sampleOf(0.21 + i * 0.01, kHolds, kServoOn, 0);
            sample.jumped = !fromHere && i == 0;
            const auto set = feed.take(sample);
            ASSERT_TRUE(set);
            EXPECT_EQ(set->gapBefore, i == 0) << i;
            EXPECT_FALSE(std::abs(set->velocity) > 0) << i << ": " << set->velocity;
        }
    }
}

TEST(ScopeFeed, TheErrorIsTheShortWayRound) {
    ScopeFeed feed;
    constexpr std::int32_t kTop = std::numeric_limits<std::int32_t>::max();
    static_cast<void>(feed.take(sampleOf(-1, kMoveDone | kPosError | kPower, 0, kTop)));
    feed.apply(executedAt(0, stopWith(servo::StopManner::Abruptly)));
    static_cast<void>(feed.take(sampleOf(0, kHolds, kServoOn, kTop)));  // held here
    const auto pushed = feed.take(sampleOf(0.01, kHolds, kServoOn, std::numeric_limits<std::int32_t>::min()));
    EXPECT_EQ(pushed->error, -1.0F);
}

TEST(ScopeFeed, TheErrorIsKnownOnceTheServoHoldsAndNotAfterADoubt) {
    ScopeFeed feed;
    EXPECT_FALSE(feed.take(sampleOf(-1, kMoveDone | kPosError | kPower, 0, 90))->errorKnown());
    feed.apply(executedAt(0, stopWith(servo::StopManner::Abruptly)));
    EXPECT_EQ(feed.take(sampleOf(0, kHolds, kServoOn, 100))->error, 0.0F);
    EXPECT_EQ(feed.take(sampleOf(0.01, kHolds, kServoOn, 97))->error, 3.0F);
    feed.doubt();
    EXPECT_FALSE(feed.take(sampleOf(0.02, kHolds, kServoOn, 97))->errorKnown());
}

TEST(ScopeFeed, AStandingMotorHasAnExactErrorAndAMovingOneABand) {
    ScopeFeed feed;
    static_cast<void>(feed.take(sampleOf(-1, kMoveDone | kPosError | kPower, 0, 0)));
    feed.apply(executedAt(0, stopWith(servo::StopManner::Abruptly)));
    const auto rest = feed.take(sampleOf(0.01, kHolds, kServoOn, 0));
    EXPECT_EQ(rest->errorLow, rest->error);
    EXPECT_EQ(rest->errorHigh, rest->error);
    feed.apply(executedAt(1, velocityMode(8 << 16, 8 << 16)));  // 8 counts/tick within a tick
    const auto prompt = feed.take(sampleOf(2, kHolds, kServoOn | kAccelDone, 15'000));
    EXPECT_LT(prompt->errorLow, prompt->error);
    EXPECT_GT(prompt->errorHigh, prompt->error);
    EXPECT_LT(prompt->errorHigh - prompt->errorLow, 2 * 2.5 * 8 + 2);
    bus::Sample delayed = sampleOf(2.01, kHolds, kServoOn | kAccelDone, 15'156);
    delayed.late = std::chrono::milliseconds(5);
    const auto late = feed.take(delayed);
    // It may have been latched up to 5 ms later, when the command position was some 78 counts further on.
    EXPECT_NEAR(late->errorHigh - late->error, (prompt->errorHigh - prompt->error) + 78, 8);
    EXPECT_NEAR(late->error - late->errorLow, prompt->error - prompt->errorLow, 8);
}

/// DS-V 4.3: beyond EL the servo switches itself off, so the error is within EL while it is on.
TEST(ScopeFeed, TheErrorOfAServoThatIsOnIsWithinItsLimit) {
    ScopeFeed feed;
    static_cast<void>(feed.take(sampleOf(-1, kMoveDone | kPosError | kPower, 0, 0)));
    servo::SetGain gains;
    gains.el = 10;
    feed.apply(executedAt(-0.5, gains));
    feed.apply(executedAt(0, stopWith(servo::StopManner::Abruptly)));
    static_cast<void>(feed.take(sampleOf(0.01, kHolds, kServoOn, 0)));
    feed.apply(executedAt(1, velocityMode(8 << 16, 8 << 16)));
    // After 1 s it has moved some 15 625 counts, known to some 20: wider than twice the limit.
    const auto sample = feed.take(sampleOf(2, kMoveDone | kPower, kServoOn, 15'620));
    ASSERT_TRUE(sample->errorKnown());
    EXPECT_GE(sample->errorLow, -10);
    EXPECT_LE(sample->errorHigh, 10);
    EXPECT_FALSE(feed.take(sampleOf(2.1, kMoveDone | kPower, kServoOn, 20'000))->errorKnown())
        << "it would have tripped, so the calculated error is wrong";
}

TEST(ScopeFeed, CarriesOnWhatABriefReplyDoesNotTell) {
    ScopeFeed feed;
    bus::Sample full = sampleOf(0, kHolds, kServoOn);
    full.report.analog = std::uint8_t{77};
    static_cast<void>(feed.take(full));
    bus::Sample brief = sampleOf(0.01, kHolds, 0);
    brief.report.aux.reset();
    EXPECT_EQ(feed.take(brief)->aux, kServoOn);
    EXPECT_EQ(feed.take(brief)->analog, 77);
}

}  // namespace
}  // namespace nmc
