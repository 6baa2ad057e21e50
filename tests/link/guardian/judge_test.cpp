// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "link/guardian/beatjudge.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kBegin(10s);

TEST(BeatJudge, HasNothingToLookAtWhileNothingMoves) {
    BeatJudge judge;
    EXPECT_FALSE(judge.lookBy({kBegin, false}));
    EXPECT_FALSE(judge.expired({kBegin, false}, kBegin + 1h));
}

TEST(BeatJudge, LooksWhenABeatWouldBeTooOldAndNotBefore) {
    BeatJudge judge;
    EXPECT_EQ(judge.lookBy({kBegin, true}), kBegin + 150ms);
    EXPECT_FALSE(judge.expired({kBegin, true}, kBegin + 149ms));
    EXPECT_TRUE(judge.expired({kBegin, true}, kBegin + 151ms));
}

TEST(BeatJudge, SaysItOnceABeat) {
    BeatJudge judge;
    ASSERT_TRUE(judge.expired({kBegin, true}, kBegin + 151ms));
    EXPECT_EQ(judge.lookBy({kBegin, true}), kBegin + 301ms) << "there may be a new one by then";
    EXPECT_FALSE(judge.expired({kBegin, true}, kBegin + 400ms));
    EXPECT_FALSE(judge.expired({kBegin, true}, kBegin + 1h));
    EXPECT_TRUE(judge.expired({kBegin + 3s, true}, kBegin + 3s + 151ms)) << "armed again by a new one";
}

TEST(BeatJudge, WhoComesLateHimselfWaitsOnePeriodMore) {
    BeatJudge judge;
    EXPECT_FALSE(judge.expired({kBegin, true}, kBegin + 171ms)) << "21 ms late";
    EXPECT_EQ(judge.lookBy({kBegin, true}), kBegin + 321ms);
    EXPECT_FALSE(judge.expired({kBegin, true}, kBegin + 320ms));
    EXPECT_TRUE(judge.expired({kBegin, true}, kBegin + 2s)) << "one period, however late he is";
}

TEST(BeatJudge, ABeatThatComesMeanwhileIsJudgedAsAnyOther) {
    BeatJudge judge;
    ASSERT_FALSE(judge.expired({kBegin, true}, kBegin + 1s));
    EXPECT_EQ(judge.lookBy({kBegin + 1s, true}), kBegin + 1s + 150ms);
    EXPECT_TRUE(judge.expired({kBegin + 1s, true}, kBegin + 1s + 155ms));
}

}  // namespace
}  // namespace nmc
