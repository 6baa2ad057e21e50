// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "link/guardian/beatmonitor.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kBegin(10s);

TEST(BeatMonitor, HasNothingToLookAtWhileNothingMoves) {
    BeatMonitor monitor;
    EXPECT_FALSE(monitor.lookBy({kBegin, false}));
    EXPECT_FALSE(monitor.expired({kBegin, false}, kBegin + 1h));
}

TEST(BeatMonitor, LooksWhenABeatWouldBeTooOldAndNotBefore) {
    BeatMonitor monitor;
    EXPECT_EQ(monitor.lookBy({kBegin, true}), kBegin + 150ms);
    EXPECT_FALSE(monitor.expired({kBegin, true}, kBegin + 149ms));
    EXPECT_TRUE(monitor.expired({kBegin, true}, kBegin + 151ms));
}

TEST(BeatMonitor, SaysItOnceABeat) {
    BeatMonitor monitor;
    ASSERT_TRUE(monitor.expired({kBegin, true}, kBegin + 151ms));
    EXPECT_EQ(monitor.lookBy({kBegin, true}), kBegin + 301ms) << "a new beat may have come by then";
    EXPECT_FALSE(monitor.expired({kBegin, true}, kBegin + 400ms));
    EXPECT_FALSE(monitor.expired({kBegin, true}, kBegin + 1h));
    EXPECT_TRUE(monitor.expired({kBegin + 3s, true}, kBegin + 3s + 151ms)) << "a new beat has armed it again";
}

TEST(BeatMonitor, WhoComesLateHimselfWaitsOnePeriodMore) {
    BeatMonitor monitor;
    EXPECT_FALSE(monitor.expired({kBegin, true}, kBegin + 171ms)) << "it looks 21 ms late";
    EXPECT_EQ(monitor.lookBy({kBegin, true}), kBegin + 321ms);
    EXPECT_FALSE(monitor.expired({kBegin, true}, kBegin + 320ms));
    EXPECT_TRUE(monitor.expired({kBegin, true}, kBegin + 2s)) << "one period more, however late it looks";
}

TEST(BeatMonitor, ABeatThatComesMeanwhileIsJudgedAsAnyOther) {
    BeatMonitor monitor;
    ASSERT_FALSE(monitor.expired({kBegin, true}, kBegin + 1s));
    EXPECT_EQ(monitor.lookBy({kBegin + 1s, true}), kBegin + 1s + 150ms);
    EXPECT_TRUE(monitor.expired({kBegin + 1s, true}, kBegin + 1s + 155ms));
}

}  // namespace
}  // namespace nmc
