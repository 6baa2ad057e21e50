// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/commandenvelope.h"

#include <gtest/gtest.h>

#include "tests/support/servotick.h"

namespace nmc {
namespace {

using testing_support::kTick;

Moments exactlyAt(double ticks) {
    const TimePoint time = TimePoint(std::chrono::seconds(1)) + fromSeconds(ticks * kTick);
    return {time, time, time, 0.0};
}

/// A move to 1000 from somewhere between -20 and 20, at up to 5 counts per tick, whose velocity is changed
/// while it slows down: a move that started farther back arrives later, and is still faster at that time.
class SlowedDown : public testing::TestWithParam<double> {
protected:
    static CommandEnvelope course(const CommandEstimate& start, double velocity) {
        constexpr double kAcceleration = 0.02;
        CommandEnvelope course(start);
        course.moveTo(1'000, 5, {kTick, kAcceleration}, exactlyAt(0));
        // Full speed would take 250 ticks and 625 counts to reach, and as much again to stop; 1000 counts
        // allow for 223.6 ticks each.
        course.changeVelocity(velocity, {kTick, 0.1}, exactlyAt(380));
        return course;
    }
};

TEST_P(SlowedDown, LeavesEveryStartThatThereMayHaveBeenInTheBand) {
    const CommandEnvelope band = course({0, -20, 20}, GetParam());
    for (double start = -20; start <= 20; start += 2.5) {
        const CommandEnvelope one = course({start, start, start}, GetParam());
        for (double ticks = 380; ticks <= 700; ticks += 10) {
            const double there = one.at(exactlyAt(ticks)).position;
            const CommandEstimate known = band.at(exactlyAt(ticks));
            EXPECT_LE(known.low, there + 0.1) << start << " after " << ticks;
            EXPECT_GE(known.high, there - 0.1) << start << " after " << ticks;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(CommandEnvelope, SlowedDown, testing::Values(8.0, 1.0, 0.0, -4.0));

}  // namespace
}  // namespace nmc
