// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/profile.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace nmc::sim {
namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t kOne = 65536;  // one count, one count per tick

struct Move {
    std::int64_t ticks = 0;
    std::int64_t peak = 0;
    std::int64_t slewTicks = 0;
};

/// Runs a move to its end; checks the two bounds of every tick.
Move finish(Profile& profile, std::int64_t vmax, std::int64_t a, std::int64_t limit = 10'000'000) {
    Move run;
    std::int64_t v = profile.velocity();
    while (!profile.done() && run.ticks < limit) {
        const std::int64_t before = profile.finePosition();
        profile.step();
        ++run.ticks;
        const std::int64_t moved = profile.finePosition() - before;
        if (std::abs(moved) > vmax)
            ADD_FAILURE() << "moved " << moved << " in tick " << run.ticks;
        // The velocity of the last step is the distance that it moved; after that, it is at rest.
        if (std::abs(moved - v) > a || (profile.done() && std::abs(moved) > a))
            ADD_FAILURE() << "velocity from " << v << " to " << moved << " in tick " << run.ticks;
        run.peak = std::max(run.peak, std::abs(moved));
        run.slewTicks += std::abs(moved) == vmax ? 1 : 0;
        v = moved;
    }
    return run;
}

TEST(Profile, ATrapezoidTakesDistanceOverVelocityPlusOneRamp) {
    // v = 2 counts/tick, a = 1/50: ramps of 100 ticks. Both ramps together cover v^2/a = 200 counts in 200
    // ticks; the remaining 800 counts take 400. In all d/v + v/a = 500 + 100.
    Profile p;
    p.startTrapezoid(1000, 2 * kOne, kOne / 50);
    const Move run = finish(p, 2 * kOne, kOne / 50);
    EXPECT_NEAR(static_cast<double>(run.ticks), 600, 2);
    EXPECT_EQ(p.finePosition(), 1000 * kOne);
    EXPECT_EQ(p.velocity(), 0);
}

TEST(Profile, AShortMoveIsTriangularWithAPeakOfRootAD) {
    Profile p;
    const std::int64_t a = 100;
    p.startTrapezoid(-5000, 0x7FFFFFFF, 100);
    const Move run = finish(p, 0x7FFFFFFF, a);
    const double peak = std::sqrt(100.0 * 5000 * kOne);
    EXPECT_NEAR(static_cast<double>(run.peak), peak, 2 * 100);
    EXPECT_NEAR(static_cast<double>(run.ticks), 2 * peak / 100, 3);
    EXPECT_EQ(p.finePosition(), -5000 * kOne);
}

TEST(Profile, WithTheLargestVelocityAndAccelerationItJumpsToTheGoalInOneTick) {
    // DS-V 4.3: "cause the trapezoidal profiling to jump to goal position in a single tick".
    Profile p;
    p.startTrapezoid(200, 0x7FFFFFFF, 0x7FFFFFFF);
    p.step();
    EXPECT_EQ(p.position(), 200);
    EXPECT_TRUE(p.done());
}

RC_GTEST_PROP(Profile, AnyTrapezoidEndsExactlyOnItsGoalWithinItsBounds, ()) {
    // Goals, velocities and accelerations of every magnitude; those that would take over a million ticks are
    // left out by choosing the distance for the velocity and acceleration.
    const auto a = *rc::gen::inRange<std::uint32_t>(1, 0x7FFFFFFF) >> *rc::gen::inRange(0, 31);
    const auto v = *rc::gen::inRange<std::uint32_t>(1, 0x7FFFFFFF) >> *rc::gen::inRange(0, 31);
    RC_PRE(a > 0U && v > 0U);
    const double ticks = *rc::gen::inRange(1, 3000);
    const double reach = std::min(ticks * v, 0.25 * ticks * ticks * a) / kOne;
    const auto limit = static_cast<std::int32_t>(std::min(reach + 2, 2e9));
    const auto begin = *rc::gen::arbitrary<std::int32_t>();
    const auto distance = *rc::gen::inRange(-limit, limit);
    const auto goal =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(distance));
    Profile p;
    p.hold(begin);
    p.startTrapezoid(goal, v, a);
    std::int64_t n = 0;
    std::int64_t speed = 0;
    while (!p.done()) {
        const std::int64_t before = p.finePosition();
        p.step();
        // Positions are 48 bits wide.
        const std::int64_t moved =
            static_cast<std::int64_t>(static_cast<std::uint64_t>(p.finePosition() - before) << 16U) >> 16;
        RC_ASSERT(std::abs(moved) <= std::int64_t{v});
        RC_ASSERT(std::abs(moved - speed) <= std::int64_t{a});
        RC_ASSERT(moved == 0 || (moved > 0) == (distance > 0));
        speed = moved;
        RC_ASSERT(++n < 2'000'000);
    }
    RC_ASSERT(std::abs(speed) <= std::int64_t{a});
    RC_ASSERT(p.finePosition() == goal * kOne);
    RC_ASSERT(p.velocity() == 0);
}

RC_GTEST_PROP(Profile, TheStoppingVelocityIsTheLargestThatStopsInTime, ()) {
    const std::int64_t a = *rc::gen::inRange<std::int64_t>(1, 0x7FFFFFFF) >> *rc::gen::inRange(0, 31);
    const std::int64_t d =
        *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 47) >> *rc::gen::inRange(0, 47);
    RC_PRE(a > 0);
    // Counts covered by v, v-a, v-2a ... while positive.
    const auto covered = [a](std::int64_t v) {
        const auto n = static_cast<Wide>((v + a - 1) / a);
        return n * v - static_cast<Wide>(a) * n * (n - 1) / 2;
    };
    const std::int64_t v = stoppingVelocity(d, a);
    RC_ASSERT(v >= 0);
    RC_ASSERT(covered(v) <= d);
    RC_ASSERT(covered(v + 1) > d);
}

TEST(Profile, WithoutAccelerationItNeverStarts) {
    Profile p;
    p.startTrapezoid(100, kOne, 0);
    for (int i = 0; i < 1000; ++i)
        p.step();
    EXPECT_EQ(p.position(), 0);
    EXPECT_FALSE(p.done());
    p.startVelocity(kOne, 0);
    for (int i = 0; i < 1000; ++i)
        p.step();
    EXPECT_EQ(p.position(), 0);
    EXPECT_FALSE(p.done());
}

TEST(Profile, WithoutVelocityItNeverStarts) {
    Profile p;
    p.startTrapezoid(100, 0, kOne);
    for (int i = 0; i < 1000; ++i)
        p.step();
    EXPECT_EQ(p.position(), 0);
    EXPECT_FALSE(p.done());
}

TEST(Profile, ATrapezoidMarksTheEndOfAccelerationAndOfSlewing) {
    Profile p;
    p.startTrapezoid(1000, 2 * kOne, kOne / 50);
    int accelerated = 0;
    int slewed = 0;
    for (int tick = 1; !p.done(); ++tick) {
        p.step();
        if (accelerated == 0 && p.accelerationDone())
            accelerated = tick;
        if (slewed == 0 && p.slewDone())
            slewed = tick;
    }
    EXPECT_NEAR(accelerated, 100, 1);
    EXPECT_NEAR(slewed, 500, 2);
    p.startTrapezoid(0, 2 * kOne, kOne / 50);
    EXPECT_FALSE(p.accelerationDone());
    EXPECT_FALSE(p.slewDone());
}

TEST(Profile, VelocityModeRampsByTheAccelerationAndKeepsTheIntegralExact) {
    Profile p;
    p.startVelocity(-10 * kOne, kOne / 8);
    std::int64_t sum = 0;
    for (std::int64_t tick = 1; tick <= 200; ++tick) {
        p.step();
        const std::int64_t expected = -std::min(tick * (kOne / 8), 10 * kOne);
        ASSERT_EQ(p.velocity(), expected);
        sum += expected;
        ASSERT_EQ(p.finePosition(), sum);
        ASSERT_EQ(p.done(), tick >= 80);
    }
}

TEST(Profile, VelocityModeMayBeEnteredInTheMiddleOfATrapezoidWithoutAJump) {
    Profile p;
    p.startTrapezoid(100000, 5 * kOne, kOne);
    for (int i = 0; i < 20; ++i)
        p.step();
    ASSERT_EQ(p.velocity(), 5 * kOne);
    p.startVelocity(2 * kOne, kOne);
    p.step();
    EXPECT_EQ(p.velocity(), 4 * kOne);
}

TEST(Profile, ASmoothStopRampsDownAndAnAbruptOneStandsAtOnce) {
    Profile p;
    p.startVelocity(4 * kOne, kOne);
    for (int i = 0; i < 10; ++i)
        p.step();
    Profile q = p;
    p.stopSmoothly();
    EXPECT_FALSE(p.done());
    for (int i = 0; i < 4; ++i)
        p.step();
    EXPECT_TRUE(p.done());
    EXPECT_EQ(p.finePosition() - q.finePosition(), (3 + 2 + 1) * kOne);
    const std::int64_t here = q.finePosition();
    q.stopAbruptly();
    q.step();
    EXPECT_TRUE(q.done());
    EXPECT_EQ(q.finePosition(), here);
}

TEST(Profile, TheCommandPositionWrapsWithThe32BitCounter) {
    Profile p;
    p.hold(std::numeric_limits<std::int32_t>::max());
    p.startVelocity(kOne, 0x7FFFFFFF);
    p.step();
    EXPECT_EQ(p.position(), std::numeric_limits<std::int32_t>::min());
}

TEST(Profile, ThePositionOfANegativeFractionIsRoundedDown) {
    Profile p;
    p.startVelocity(-1, 1);
    p.step();
    EXPECT_EQ(p.finePosition(), -1);
    EXPECT_EQ(p.position(), -1);
}

RC_GTEST_PROP(Profile, AMoveThatBeginsInMotionKeepsToItsAccelerationAndEndsOnItsGoal, ()) {
    const auto a = *rc::gen::inRange<std::uint32_t>(1, 40'000);
    const auto vmax = *rc::gen::inRange<std::uint32_t>(65'536, 20 * 65'536);
    Profile p;
    p.startVelocity(*rc::gen::inRange<std::int64_t>(-20 * kOne, 20 * kOne), a);
    for (int ticks = *rc::gen::inRange(0, 200); ticks > 0; --ticks)
        p.step();
    const auto goal = *rc::gen::inRange(-20'000, 20'000);
    p.startTrapezoid(goal, vmax, a, Profile::Start::AtPresentVelocity);
    for (int tick = 0; !p.done(); ++tick) {
        const std::int64_t before = p.finePosition();
        const std::int64_t speed = p.velocity();
        p.step();
        const std::int64_t moved = p.finePosition() - before;
        RC_ASSERT(std::abs(moved - speed) <= std::int64_t{a});
        RC_ASSERT(!p.done() || std::abs(moved) <= std::int64_t{a});
        RC_ASSERT(tick < 10'000'000);
    }
    RC_ASSERT(p.finePosition() == goal * kOne);
    RC_ASSERT(p.velocity() == 0);
}

TEST(Profile, TellsWhetherItAcceleratesOrSlews) {
    Profile p;
    EXPECT_FALSE(p.accelerating() || p.slewing()) << "power-up";
    p.follow(0, 0);
    EXPECT_TRUE(p.slewing()) << "stopped";
    p.startTrapezoid(100, 2 * kOne, kOne);
    p.step();
    EXPECT_TRUE(p.accelerating() && !p.slewing());
    p.step();
    EXPECT_TRUE(p.accelerating());
    p.step();
    EXPECT_TRUE(!p.accelerating() && p.slewing());
    while (p.position() < 98)
        p.step();
    p.step();
    EXPECT_FALSE(p.accelerating() || p.slewing()) << "decelerating";
}

}  // namespace
}  // namespace nmc::sim
