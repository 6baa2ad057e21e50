// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace nmc::sim {
namespace {

/// A word and its counts: the magnitude is above F, D and the zeros of its rate.
struct Segment {
    int counts = 0;
    int ticks = 0;
    std::uint16_t word = 0;
};

Segment anySegment(bool fastPath) {
    const bool longer = *rc::gen::arbitrary<bool>();
    const int ticks = (longer ? 64 : 32) / (fastPath ? 2 : 1);
    const int counts = *rc::gen::inRange(-256 * ticks + 1, 256 * ticks);
    const unsigned magnitude =
        static_cast<unsigned>(counts < 0 ? -counts : counts) * 256U / static_cast<unsigned>(ticks);
    return {counts, ticks,
            static_cast<std::uint16_t>(magnitude | (longer ? 2U : 0U) | (counts < 0 ? 1U : 0U))};
}

RC_GTEST_PROP(Path, EndsEverySegmentExactlyOnItsPoint, (bool fastPath)) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 128);
    std::vector<Segment> segments;
    Path path(128);
    for (std::size_t i = 0; i < count; ++i) {
        segments.push_back(anySegment(fastPath));
        RC_ASSERT(path.add(segments.back().word));
    }
    path.start();
    std::int64_t position = 0;
    std::int64_t goal = 0;
    for (const Segment& segment : segments) {
        for (int tick = 0; tick < segment.ticks; ++tick)
            position += path.next(fastPath).value();
        goal += segment.counts;
        RC_ASSERT(position == goal * 65536);
    }
    RC_ASSERT(path.running());
    RC_ASSERT(!path.next(fastPath).has_value());
    RC_ASSERT(!path.running());
}

TEST(Path, TakesThePointOutOfTheBufferWhenItBegins) {
    Path path(3);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(path.add(0x08));
    EXPECT_FALSE(path.add(0x08));
    path.start();
    EXPECT_EQ(path.points(), 3U);
    path.next(false);
    EXPECT_EQ(path.points(), 2U);
    EXPECT_TRUE(path.add(0x08));
    path.end();
    EXPECT_EQ(path.points(), 0U);
    EXPECT_FALSE(path.running());
}

TEST(Path, OlderServosHaveNoBuffer) {
    EXPECT_EQ(Path::capacityOf(4), 0U);
    EXPECT_EQ(Path::capacityOf(5), 96U);
    EXPECT_EQ(Path::capacityOf(10), 128U);
}

}  // namespace
}  // namespace nmc::sim
