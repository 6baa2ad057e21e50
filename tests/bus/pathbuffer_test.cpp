// SPDX-License-Identifier: GPL-3.0-or-later
// Expected values are counted by hand: one point leaves the buffer in each period.
#include "bus/pathbuffer.h"

#include <gtest/gtest.h>

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using bus::PathBuffer;

constexpr Duration kPeriod = 10ms;

[[nodiscard]] TimePoint at(Duration time) {
    return TimePoint{} + time;
}

/// A buffer that is filled completely before it runs.
PathBuffer filled(std::size_t points, std::size_t capacity = 128) {
    PathBuffer buffer(points, capacity, kPeriod);
    while (buffer.frame() > 0 && buffer.roomAt() == TimePoint::min())
        buffer.onSent(buffer.frame());
    return buffer;
}

TEST(PathBuffer, IsFilledInFramesOfSeven) {
    EXPECT_EQ(filled(1'000).sent(), 126U);
    EXPECT_EQ(filled(1'000, 96).sent(), 91U);
    EXPECT_EQ(filled(1'000).roomAt(), TimePoint::max()) << "no point leaves before it runs";
    EXPECT_EQ(filled(20).sent(), 20U);
    EXPECT_TRUE(filled(20).sentAll());
    EXPECT_EQ(filled(20).frame(), 0U);
}

/// A frame of only a point or two could not be distinguished from a frame that was lost.
TEST(PathBuffer, NeverEndsInAShortFrame) {
    for (std::size_t points = 4; points < 40; ++points) {
        PathBuffer buffer(points, 128, kPeriod);
        std::size_t frames = 0;
        for (; buffer.frame() > 0; ++frames) {
            EXPECT_GE(buffer.frame(), 4U) << points;
            EXPECT_LE(buffer.frame(), 7U) << points;
            buffer.onSent(buffer.frame());
        }
        EXPECT_EQ(buffer.sent(), points);
        EXPECT_EQ(frames, (points + 6) / 7);
    }
}

TEST(PathBuffer, HasRoomWhenSoManyHaveLeft) {
    PathBuffer buffer = filled(1'000);
    buffer.start(at(0ms));
    // 126 + 7 points are 5 more than fit.
    EXPECT_EQ(buffer.roomAt(), at(5 * kPeriod + kServoTick));
    EXPECT_EQ(buffer.taken(at(5 * kPeriod)), 4U) << "its tick may be a tick later than ours";
    EXPECT_EQ(buffer.taken(at(5 * kPeriod + kServoTick)), 5U);
    buffer.onReported(119, at(60ms), at(61ms));
    EXPECT_EQ(buffer.taken(at(61ms)), 7U);
    EXPECT_EQ(buffer.roomAt(), TimePoint::min());
    EXPECT_EQ(buffer.dryAt(), at(60ms + 119 * kPeriod));
}

TEST(PathBuffer, TellsAFrameThatWasCarriedOutFromOneThatWasLost) {
    PathBuffer buffer = filled(1'000);
    EXPECT_EQ(buffer.carriedOut(2, 126, at(0ms), at(0ms)), false) << "the number is exact before it runs";
    EXPECT_EQ(buffer.carriedOut(2, 128, at(0ms), at(0ms)), true);
    EXPECT_EQ(buffer.carriedOut(2, 127, at(0ms), at(0ms)), std::nullopt);
    buffer.start(at(0ms));
    buffer.onReported(120, at(60ms), at(60ms));
    // 200 ms later, 20 points have left, or one more or less.
    for (const std::size_t left : {99U, 100U, 101U})
        EXPECT_EQ(buffer.carriedOut(7, left, at(260ms), at(260ms)), false) << left;
    for (const std::size_t left : {106U, 107U, 108U})
        EXPECT_EQ(buffer.carriedOut(7, left, at(260ms), at(260ms)), true) << left;
    for (const std::size_t left : {97U, 103U, 110U})
        EXPECT_EQ(buffer.carriedOut(7, left, at(260ms), at(260ms)), std::nullopt) << left;
    // The time is known to 60 ms only, which are six points: 102 may mean either.
    EXPECT_EQ(buffer.carriedOut(4, 102, at(230ms), at(290ms)), std::nullopt);
}

}  // namespace
}  // namespace nmc::test
