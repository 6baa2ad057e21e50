// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bus/pollschedule.h"
#include "tests/support/modules.h"

namespace nmc::test {

namespace {

using namespace std::chrono_literals;
using bus::PollSchedule;
using testing_support::kFirst;
using testing_support::kSecond;

void silence(PollSchedule& schedule, ModuleIndex module, TimePoint now) {
    schedule.lose(module, now);
}

TEST(PollSchedule, TakesModulesInTurn) {
    PollSchedule schedule(3);
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(schedule.next(TimePoint{})->module.value(), i % 3);
}

TEST(PollSchedule, AsksForEverythingEverySecondTime) {
    PollSchedule schedule(2);
    for (int i = 0; i < 32; ++i)
        EXPECT_EQ(schedule.next(TimePoint{})->full, i / 2 % 2 == 0) << i;
}

/// Polls of each module in `time` when every poll takes 10 ms.
std::vector<int> pollsIn(PollSchedule& schedule, std::size_t modules, Duration time) {
    std::vector<int> polls(modules);
    for (TimePoint now{}; now < TimePoint(time); now += 10ms)
        ++polls[schedule.next(now)->module.value()];
    return polls;
}

TEST(PollSchedule, GivesAWatchedModuleWhatTheOthersDoNotNeed) {
    PollSchedule schedule(3);
    schedule.watch({kSecond});
    const std::vector<int> polls = pollsIn(schedule, 3, 10s);
    EXPECT_GE(polls[0], 50) << "five a second";
    EXPECT_LE(polls[0], 60);
    EXPECT_GE(polls[2], 50);
    EXPECT_LE(polls[2], 60);
    EXPECT_GE(polls[1], 880) << "of 1000";
}

TEST(PollSchedule, GivesAWatchedModuleEveryOtherTurnWhenTheWireIsFull) {
    PollSchedule schedule(32);
    schedule.watch({kFirst});
    const std::vector<int> polls = pollsIn(schedule, 32, 10s);
    EXPECT_NEAR(polls[0], 500, 2);
    for (std::size_t i = 1; i < 32; ++i)
        EXPECT_NEAR(polls[i], 500 / 31, 2);
}

TEST(PollSchedule, TreatsAllAlikeWhenNobodyLooks) {
    PollSchedule schedule(3);
    schedule.watch({kSecond, ModuleIndex(77)});
    schedule.watch({});
    EXPECT_EQ(pollsIn(schedule, 3, 3s), (std::vector<int>{100, 100, 100}));
}

/// With a focus that is renewed as long as it is wanted.
TEST(PollScheduleFocus, AsksTheOthersOnceASecondAndNeverTwiceInARow) {
    PollSchedule schedule(32);
    schedule.watch({kSecond});
    std::vector<int> polls(32);
    std::vector<TimePoint> asked(32);
    bool otherBefore = false;
    for (TimePoint now{}; now < TimePoint(4s); now += 2ms) {
        if (now == TimePoint{} || now == TimePoint(2s))
            schedule.focus(kFirst, now);
        const std::size_t module = schedule.next(now)->module.value();
        ++polls[module];
        EXPECT_LE(now - asked[module], Duration(1s)) << module;
        asked[module] = now;
        EXPECT_FALSE(otherBefore && module != 0);
        otherBefore = module != 0;
    }
    for (std::size_t i = 1; i < 32; ++i)
        EXPECT_GE(polls[i], 4) << i;
    EXPECT_GE(polls[0], 2'000 - 31 * 5) << "of 2000";
}

/// Renews the focus often, as a square wave does with each edge.
TEST(PollScheduleFocus, LeavesTheOthersTheirTurnsHoweverOftenItIsRenewed) {
    PollSchedule schedule(3);
    std::vector<int> polls(3);
    for (TimePoint now{}; now < TimePoint(9s); now += 10ms) {
        if (now.time_since_epoch() % 50ms == Duration{})
            schedule.focus(kFirst, now);
        ++polls[schedule.next(now)->module.value()];
    }
    EXPECT_GE(polls[1], 9) << "once in 0.9 s";
    EXPECT_GE(polls[2], 9);
    EXPECT_GE(polls[0], 900 - 2 * 11);
}

TEST(PollScheduleFocus, AlternatesTwoLayoutsOfWhichNoneIsFull) {
    PollSchedule schedule(1);
    schedule.focus(kFirst, TimePoint{});
    for (int i = 0; i < 8; ++i) {
        const auto turn = schedule.next(TimePoint{});
        EXPECT_EQ(turn->brief, i % 2 == 0);
        EXPECT_FALSE(turn->full);
    }
}

TEST(PollScheduleFocus, IsOverAfterFiveSecondsOrWhenEnded) {
    PollSchedule schedule(3);
    schedule.focus(kSecond, TimePoint{});
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(schedule.next(TimePoint(10ms))->module, kSecond);
    std::vector<int> after(3);
    for (int i = 0; i < 30; ++i)
        ++after[schedule.next(TimePoint(5s))->module.value()];
    EXPECT_EQ(after, (std::vector<int>{10, 10, 10}));
    schedule.focus(kSecond, TimePoint(6s));
    schedule.unfocus();
    EXPECT_FALSE(schedule.next(TimePoint(6s))->brief);
}

TEST(PollScheduleFocus, LeavesSilentModulesAlone) {
    PollSchedule schedule(2);
    silence(schedule, kSecond, TimePoint{});
    schedule.focus(kFirst, TimePoint(1s));
    for (TimePoint now(1s); now < TimePoint(5s); now += 10ms)
        EXPECT_EQ(schedule.next(now)->module, kFirst);
    EXPECT_EQ(schedule.next(TimePoint(6s))->module, kSecond)
        << "its time-outs do not disturb the focus any more";
}

TEST(PollScheduleFocus, IsNotForAModuleThatIsSilentOrFallsSilent) {
    PollSchedule schedule(2);
    silence(schedule, kSecond, TimePoint{});
    schedule.focus(kSecond, TimePoint{});
    EXPECT_EQ(schedule.next(TimePoint{})->module, kFirst);
    schedule.recover(kSecond, TimePoint{});
    schedule.focus(kFirst, TimePoint{});
    silence(schedule, kFirst, TimePoint{});
    const auto turn = schedule.next(TimePoint{});
    EXPECT_EQ(turn->module, kSecond);
    EXPECT_FALSE(turn->brief);
}

TEST(PollSchedule, ForgetsARetiredModule) {
    PollSchedule schedule(2);
    silence(schedule, kFirst, TimePoint{});
    schedule.retire(kFirst);
    EXPECT_EQ(pollsIn(schedule, 2, 10s), (std::vector<int>{0, 1000}));
}

TEST(PollSchedule, KnowsWhoIsSilent) {
    PollSchedule schedule(2);
    silence(schedule, kFirst, TimePoint{});
    EXPECT_TRUE(schedule.silent(kFirst));
    EXPECT_EQ(schedule.answering(), 1U);
    EXPECT_FALSE(schedule.allUnresponsive());
    schedule.recover(kFirst, TimePoint{});
    EXPECT_FALSE(schedule.silent(kFirst));
}

TEST(PollSchedule, AsksASilentModuleEverMoreRarely) {
    PollSchedule schedule(2);
    silence(schedule, kFirst, TimePoint{});
    std::vector<TimePoint> asked;
    for (TimePoint now{}; now < TimePoint(20s); now += 10ms) {
        if (schedule.next(now)->module != kFirst)
            continue;
        asked.push_back(now);
        schedule.onTimeout(kFirst, now);
    }
    ASSERT_GE(asked.size(), 4U);
    EXPECT_EQ(asked[0], TimePoint(1s));
    EXPECT_EQ(asked[1] - asked[0], Duration(2s));
    EXPECT_EQ(asked[2] - asked[1], Duration(4s));
    EXPECT_EQ(asked[3] - asked[2], Duration(4s));
}

TEST(PollSchedule, SpacesTheQuestionsToSeveralSilentModules) {
    PollSchedule schedule(32);
    for (std::uint8_t i = 1; i < 32; ++i)
        silence(schedule, ModuleIndex(i), TimePoint{});
    int probes = 0;
    for (TimePoint now{}; now < TimePoint(10s); now += 10ms) {
        const auto turn = schedule.next(now);
        if (turn->module == kFirst)
            continue;
        ++probes;
        schedule.onTimeout(turn->module, now);
    }
    EXPECT_LE(probes, 10) << "one a second";
    EXPECT_GE(probes, 9);
}

TEST(PollSchedule, AsksOnceASecondWhenAllAreSilent) {
    PollSchedule schedule(2);
    silence(schedule, kFirst, TimePoint{});
    silence(schedule, kSecond, TimePoint{});
    EXPECT_TRUE(schedule.allUnresponsive());
    EXPECT_FALSE(schedule.next(TimePoint{}));
    std::vector<int> asked;
    for (TimePoint now{}; now < TimePoint(6500ms);) {
        now = *schedule.nextDue();
        const auto turn = schedule.next(now);
        ASSERT_TRUE(turn) << "it is due, but there is nothing to do";
        asked.push_back(turn->module.value());
        schedule.onTimeout(turn->module, now + 20ms);
    }
    EXPECT_EQ(asked, (std::vector<int>{0, 1, 0, 1, 0, 1, 0}));
}

TEST(PollSchedule, AsksTheOthersSoonWhenOneAnswersAgain) {
    PollSchedule schedule(2);
    silence(schedule, kFirst, TimePoint{});
    silence(schedule, kSecond, TimePoint{});
    EXPECT_EQ(schedule.next(TimePoint(1s))->module, kFirst);
    schedule.recover(kFirst, TimePoint(1s));
    EXPECT_EQ(schedule.next(TimePoint(1s))->module, kSecond);
    EXPECT_TRUE(schedule.next(TimePoint(1s))->full) << "everything may have changed";
}

TEST(PollSchedule, HasNothingToDoWithoutModules) {
    PollSchedule schedule(0);
    EXPECT_FALSE(schedule.next(TimePoint{}));
    EXPECT_FALSE(schedule.nextDue());
    EXPECT_FALSE(schedule.allUnresponsive());
}

}  // namespace

}  // namespace nmc::test
