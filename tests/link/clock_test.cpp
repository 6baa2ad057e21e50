// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/clock.h"

#include <gtest/gtest.h>

#include <ctime>

namespace nmc {
namespace {

/// The wall clock may be set, corrected, or moved to summer time: no time is taken from it.
TEST(H06_WallClock, IsNotWhereTimeComesFrom) {
    const auto monotonic = [] {
        timespec time{};
        ::clock_gettime(CLOCK_MONOTONIC, &time);
        return TimePoint(std::chrono::seconds(time.tv_sec) + Duration(time.tv_nsec));
    };
    const TimePoint before = monotonic();
    const TimePoint now = monotonicNow();
    EXPECT_LE(before, now);
    EXPECT_LE(now, monotonic());
}

}  // namespace
}  // namespace nmc
