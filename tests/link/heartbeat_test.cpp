// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/connection/heartbeat.h"

#include <gtest/gtest.h>

#include "link/connection/suspendwatch.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint at(Duration time) {
    return TimePoint(time);
}

/// A heart whose first expected beat came after 10 s.
struct ShownSince10s : Heartbeat {
    ShownSince10s() {
        begin();
        found();
        for (int i = 0; i <= kShown; ++i)
            EXPECT_FALSE(beat(at(9s + i * 100ms)).has_value());
    }
};

TEST(H01_Heartbeat, IsMissedAfterTwoSecondsOnce) {
    ShownSince10s heart;
    EXPECT_FALSE(heart.missed(at(11'999ms), true));
    EXPECT_EQ(heart.deadline(true), at(12s));
    EXPECT_TRUE(heart.missed(at(12s), true));
    EXPECT_FALSE(heart.missed(at(12'100ms), true)) << "reported once";
    EXPECT_EQ(heart.deadline(true), std::nullopt);
}

TEST(H01_Heartbeat, IsNotMissedWhileNothingMoves) {
    ShownSince10s heart;
    EXPECT_FALSE(heart.missed(at(60s), false));
    EXPECT_EQ(heart.deadline(false), std::nullopt) << "nothing has to wake up for it";
    EXPECT_TRUE(heart.missed(at(61s), true));
}

TEST(H01_Heartbeat, TellsOfTheGapWhenItIsBack) {
    ShownSince10s heart;
    ASSERT_TRUE(heart.missed(at(12s), true));
    const auto gap = heart.beat(at(13'100ms));
    ASSERT_TRUE(gap.has_value());
    EXPECT_EQ(gap->length, 3'100ms);
    EXPECT_TRUE(gap->stopped);
    EXPECT_FALSE(heart.beat(at(13'200ms)).has_value());
    EXPECT_FALSE(heart.missed(at(15s), true));
    EXPECT_TRUE(heart.missed(at(15'200ms), true)) << "the next gap counts again";
}

TEST(H01_Heartbeat, NotesAGapOfMoreThanASecondButNoneOfLess) {
    ShownSince10s heart;
    EXPECT_FALSE(heart.beat(at(11s)).has_value()) << "exactly 1 s is not more";
    const auto gap = heart.beat(at(12'001ms));
    ASSERT_TRUE(gap.has_value());
    EXPECT_FALSE(gap->stopped);
}

TEST(H01_Heartbeat, IsNotExpectedWhileTheWindowIsStillBeingBuilt) {
    ShownSince10s heart;
    heart.begin();  // the next connection
    EXPECT_FALSE(heart.beat(at(20s)).has_value());
    EXPECT_FALSE(heart.missed(at(30s), true)) << "no chain has been found";
    heart.found();
    EXPECT_EQ(heart.deadline(true), std::nullopt);
    EXPECT_FALSE(heart.beat(at(31s)).has_value()) << "that took 11 s, and stopped nothing";
    EXPECT_FALSE(heart.beat(at(31'100ms)).has_value());
    EXPECT_FALSE(heart.missed(at(34s), true)) << "one beat is not yet a window that works";
    for (Duration time = 34s; time <= 35s; time += 100ms)
        EXPECT_FALSE(heart.beat(at(time)).has_value());
    EXPECT_FALSE(heart.missed(at(36'999ms), true));
    EXPECT_TRUE(heart.missed(at(37s), true));
}

TEST(H01_Heartbeat, IsExpectedFromTheFirstCommandOn) {
    Heartbeat heart;
    heart.begin();
    heart.commanded(at(10s));
    EXPECT_FALSE(heart.missed(at(11'999ms), true));
    EXPECT_TRUE(heart.missed(at(12s), true));
    heart.begin();
    EXPECT_FALSE(heart.missed(at(60s), true));
}

TEST(H07_Stall, OfASecondIsNoReasonToStop) {
    ShownSince10s heart;
    EXPECT_FALSE(heart.missed(at(11s), true));
}

TEST(H05_SuspendWatch, TellsOnceHowLongTheMachineSlept) {
    SuspendWatch watch;
    EXPECT_FALSE(watch.check(3h).has_value()) << "it slept before this connection";
    EXPECT_FALSE(watch.check(3h + 2us).has_value());
    EXPECT_EQ(watch.check(5h), 2h);
    EXPECT_FALSE(watch.check(5h).has_value());
    EXPECT_EQ(watch.check(5h + 500ms), 500ms);
}

TEST(H05_SuspendWatch, IsNotFooledByClocksThatAreReadOneAfterTheOther) {
    SuspendWatch watch;
    (void)watch.check(1s);
    for (int i = 0; i < 1'000; ++i)
        EXPECT_FALSE(watch.check(1s + i * 1us).has_value());
}

}  // namespace
}  // namespace nmc
