// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/tickclock.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using namespace std::chrono_literals;

constexpr TimePoint kTickZero = TimePoint(10s);

/// The window in which something was latched: from `before` before the tick to `behind` after it.
TickClock::Window around(TimePoint tick, Duration before, Duration behind) {
    return {tick - before, tick + behind};
}
TimePoint tickAt(int count) {
    return kTickZero + count * kServoTick;
}

class Ticks : public testing::Test {
protected:
    void learn(int tick, Duration before, Duration behind, bool resting = false) {
        clock.learn(around(tickAt(tick), before, behind), resting);
    }
    [[nodiscard]] std::optional<TickClock::Window> in(int tick, Duration before, Duration behind) const {
        return clock.ticksIn(around(tickAt(tick), before, behind));
    }
    TickClock clock;
};

TEST_F(Ticks, AreNotCountedByWindowsInWhichThereMayBeTwo) {
    learn(0, 256us, 256us, true);
    EXPECT_FALSE(clock.counts());
    EXPECT_FALSE(in(0, 10us, 10us));
}

TEST_F(Ticks, AreNotCountedFromTheMiddleOfAMotion) {
    learn(0, 100us, 100us, false);
    EXPECT_FALSE(clock.counts());
}

TEST_F(Ticks, BetweenTwoCommandsAreKnownThoughTheMomentsAreNot) {
    learn(0, 200us, 90us, true);
    std::optional<TickClock::Window> run;
    for (int tick = 3; tick <= 699; tick += 3) {
        learn(tick, 200us, 90us);
        if (tick == 300)
            run = in(300, 400us, 60us);
    }
    const auto stop = in(700, 30us, 300us);
    ASSERT_TRUE(run && stop);
    EXPECT_EQ(run->earliest, run->latest);
    EXPECT_EQ(stop->earliest, stop->latest);
    EXPECT_EQ(stop->earliest - run->earliest, 400 * kServoTick);
}

// The tick is uncertain by 100 us on each side: a window up to 900 us after it contains that tick and the
// next.
TEST_F(Ticks, ThatMayBeMeantByALongWindowAreAllThereAre) {
    learn(0, 100us, 100us, true);
    const auto meant = in(0, 100us, 900us);
    ASSERT_TRUE(meant);
    EXPECT_EQ(meant->latest - meant->earliest, kServoTick);
    const auto more = in(0, 100us, 950us);
    ASSERT_TRUE(more);
    EXPECT_EQ(more->latest - more->earliest, 2 * kServoTick)
        << "1024 us after it, or up to 100 us before that";
}

// Two clocks 50 ppm fast and slow are 100 us apart after a second.
TEST_F(Ticks, AreCountedOnWhenClocksRunApart) {
    learn(0, 150us, 150us, true);
    Duration apart{};
    for (int tick = 4; tick <= 40'000; tick += 4) {
        apart += 4 * kServoTick / 10'000;
        clock.learn({tickAt(tick) + apart - 150us, tickAt(tick) + apart + 150us}, false);
        ASSERT_TRUE(clock.counts()) << tick;
    }
    EXPECT_GT(apart, 2ms) << "four ticks";
    const auto last = clock.ticksIn({tickAt(40'000) + apart - 150us, tickAt(40'000) + apart + 150us});
    ASSERT_TRUE(last);
    EXPECT_EQ(last->earliest, kTickZero + 40'000 * kServoTick)
        << "by the module's clock, which began together with ours";
    EXPECT_EQ(last->latest, last->earliest);
}

TEST_F(Ticks, EndWhereNoneCanBe) {
    learn(0, 50us, 50us, true);
    clock.learn({tickAt(10) + 150us, tickAt(10) + 350us}, false);
    EXPECT_FALSE(clock.counts());
    learn(20, 50us, 50us);
    EXPECT_FALSE(clock.counts()) << "something still moves that was counted before";
    learn(30, 50us, 50us, true);
    EXPECT_TRUE(clock.counts());
}

TEST_F(Ticks, AreNotCountedOnALineThatSeldomTells) {
    learn(0, 50us, 50us, true);
    learn(200, 256us, 900us, true);
    EXPECT_FALSE(clock.counts()) << "the last useful window is 0.1 s old, and nothing moves";
}

}  // namespace
}  // namespace nmc
