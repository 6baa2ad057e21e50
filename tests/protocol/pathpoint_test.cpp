// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/pathpoint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/pathwords.h"

namespace nmc::servo {
namespace {

using test::fromPathWord;

TEST(PathWord, HasMagnitudeAndBitsWhereTheFamilyPagePutsThem) {
    // 30 Hz P13..P0 F=1 D; 60 Hz P12..P0 0 F=0 D; with fast path 60 Hz P12..P0 0 F=1 D, 120 Hz P11..P0 0 0
    // F=0 D.
    EXPECT_EQ(toPathWord({1, PathRate::Hz30}, false), 0x0004 | 0x02);
    EXPECT_EQ(toPathWord({-1, PathRate::Hz30}, false), 0x0004 | 0x03);
    EXPECT_EQ(toPathWord({1, PathRate::Hz60}, false), 0x0008);
    EXPECT_EQ(toPathWord({1, PathRate::Hz60}, true), 0x0008 | 0x02);
    EXPECT_EQ(toPathWord({-1, PathRate::Hz120}, true), 0x0010 | 0x01);
    EXPECT_EQ(toPathWord({-100, PathRate::Hz60}, false), 0x0321);  // the sheet's sample
}

TEST(PathWord, HoldsAsManyBitsAsTheRateLeaves) {
    EXPECT_EQ(maxPathCounts(PathRate::Hz30), 16'383);  // 14 bits
    EXPECT_EQ(maxPathCounts(PathRate::Hz60), 8'191);
    EXPECT_EQ(maxPathCounts(PathRate::Hz120), 4'095);
    EXPECT_EQ(toPathWord({16'383, PathRate::Hz30}, false), 0xFFFE);
    EXPECT_EQ(toPathWord({4'095, PathRate::Hz120}, true), 0xFFF0);
    EXPECT_FALSE(toPathWord({16'384, PathRate::Hz30}, false).has_value());
    EXPECT_FALSE(toPathWord({-8'192, PathRate::Hz60}, false).has_value());
}

TEST(PathWord, KnowsTheRatesOfEachMode) {
    EXPECT_FALSE(toPathWord({1, PathRate::Hz30}, true).has_value());
    EXPECT_FALSE(toPathWord({1, PathRate::Hz120}, false).has_value());
    EXPECT_EQ(fromPathWord(0x0006, true), std::nullopt);  // 60 Hz requires bit 2 to be clear
    EXPECT_EQ(fromPathWord(0x0008, true), std::nullopt);  // 120 Hz requires bits 2 and 3 to be clear
}

TEST(PathWord, IsTheSpeedThatEndsOnThePoint) {
    // P counts take 64, 32 or 16 ticks of 0.512 ms: 30.5, 61.0 and 122.1 Hz.
    EXPECT_EQ(ticksPerPoint(PathRate::Hz30), 64);
    EXPECT_EQ(ticksPerPoint(PathRate::Hz60), 32);
    EXPECT_EQ(ticksPerPoint(PathRate::Hz120), 16);
    EXPECT_EQ((*toPathWord({77, PathRate::Hz30}, false) & 0xFFFC) * 64 / 256, 77);
    EXPECT_EQ((*toPathWord({77, PathRate::Hz60}, true) & 0xFFFC) * 32 / 256, 77);
    EXPECT_EQ((*toPathWord({77, PathRate::Hz120}, true) & 0xFFFC) * 16 / 256, 77);
}

RC_GTEST_PROP(PathWord, DecodesToThePointItWasMadeFrom, (bool fastPath)) {
    const auto rate = *rc::gen::element(PathRate::Hz30, PathRate::Hz60, PathRate::Hz120);
    const PathPoint point{*rc::gen::inRange(-maxPathCounts(rate), maxPathCounts(rate) + 1), rate};
    const auto word = toPathWord(point, fastPath);
    RC_PRE(word.has_value());
    RC_ASSERT(fromPathWord(*word, fastPath) == point);
}

}  // namespace
}  // namespace nmc::servo
