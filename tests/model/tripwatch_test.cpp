// SPDX-License-Identifier: GPL-3.0-or-later
// The probable cause of a position error, from what was seen before it.
#include "model/module/tripwatch.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using namespace std::chrono_literals;

/// A move forward from rest at 1 000 counts/s that had been running for half a second.
[[nodiscard]] TripFacts forward() {
    TripFacts f;
    f.errorLimit = 500;
    f.direction = 1;
    f.velocity = 1'000.0;
    f.since = 500ms;
    return f;
}

TEST(TripCause, AMotorThatRunsAwayAsSoonAsItIsEnabledIsReversed) {
    TripFacts f;
    f.errorLimit = 500;
    f.enabled = true;
    f.since = 100ms;
    f.moved = f.farthest = 700;
    EXPECT_EQ(diagnose(f), TripCause::Reversed);
    f.moved = f.rearmost = -700;
    f.farthest = 0;
    EXPECT_EQ(diagnose(f), TripCause::Reversed) << "either way";
}

TEST(TripCause, ThatIsNotSaidOfOneThatIsPushedLaterOrSwings) {
    TripFacts f;
    f.errorLimit = 500;
    f.enabled = true;
    f.since = 5s;
    f.moved = f.farthest = 700;
    EXPECT_EQ(diagnose(f), TripCause::Unknown) << "it has held for five seconds";
    f.since = 100ms;
    f.rearmost = -300;
    EXPECT_EQ(diagnose(f), TripCause::Unknown) << "it moved to both sides, so the gains are to blame";
    f.rearmost = 0;
    f.enabled = false;
    EXPECT_EQ(diagnose(f), TripCause::Unknown) << "it was stopped out of a motion";
}

TEST(TripCause, AMotorThatGoesAgainstItsCommandIsReversed) {
    TripFacts f = forward();
    f.moved = f.rearmost = -300;
    f.speed = 20'000.0;
    EXPECT_EQ(diagnose(f), TripCause::Reversed);
    f.direction = -1;
    f.moved = f.farthest = 300;
    f.rearmost = 0;
    EXPECT_EQ(diagnose(f), TripCause::Reversed);
    f.moved = -20;
    EXPECT_NE(diagnose(f), TripCause::Reversed) << "a tenth of 500 is 50";
}

TEST(TripCause, AMotorThatStandsIsJammed) {
    TripFacts f = forward();
    EXPECT_EQ(diagnose(f), TripCause::Jam) << "it has never moved";
    f.moved = f.farthest = 4'000;
    f.speed = 30.0;
    EXPECT_EQ(diagnose(f), TripCause::Jam) << "it has moved, but does not move any more";
}

TEST(TripCause, AMotorThatMovesButLagsIsBehind) {
    TripFacts f = forward();
    f.moved = f.farthest = 4'000;
    f.speed = 600.0;
    EXPECT_EQ(diagnose(f), TripCause::Behind);
}

TEST(TripCause, ALimitThatClosedOnTheWayComesBeforeTheJamBehindIt) {
    TripFacts f = forward();
    f.moved = f.farthest = 4'000;
    f.limit2Closed = true;
    EXPECT_EQ(diagnose(f), TripCause::Limit2);
    f.limit1Closed = true;
    EXPECT_EQ(diagnose(f), TripCause::Limit1);
    f.moved = f.rearmost = -300;
    EXPECT_EQ(diagnose(f), TripCause::Reversed) << "it ran into the switch on the other side";
}

TEST(TripWatch, MeasuresFromTheCommandOn) {
    constexpr TimePoint kStart{10s};
    TripWatch watch;
    EXPECT_FALSE(watch.facts({kStart, 0, false, false}, 500)) << "no command was sent";
    watch.apply(TripWatch::Reading{kStart, 100, true, false});
    watch.apply(TripWatch::Command{kStart + 5ms, false, true, 1, 1'000.0});
    watch.apply(TripWatch::Reading{kStart + 100ms, 160, true, false});
    watch.apply(TripWatch::Reading{kStart + 200ms, 80, true, false});
    const auto facts = watch.facts({kStart + 300ms, 90, true, true}, 500);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->errorLimit, 500);
    EXPECT_FALSE(facts->enabled);
    EXPECT_EQ(facts->direction, 1);
    EXPECT_EQ(facts->since, 295ms);
    EXPECT_EQ(facts->moved, -10);
    EXPECT_EQ(facts->farthest, 60);
    EXPECT_EQ(facts->rearmost, -20);
    EXPECT_DOUBLE_EQ(facts->speed, 100.0) << "10 counts in 0.1 s";
    EXPECT_FALSE(facts->limit1Closed) << "it was closed before";
    EXPECT_TRUE(facts->limit2Closed);
    watch.apply(TripWatch::Command{kStart + 300ms, false, false, -1, 1'000.0});
    EXPECT_EQ(watch.facts({kStart + 400ms, 90, true, true}, 500)->direction, 0)
        << "out of another motion, its first direction shows nothing";
    watch.forget();
    EXPECT_FALSE(watch.facts({kStart, 0, false, false}, 500));
}

}  // namespace
}  // namespace nmc
