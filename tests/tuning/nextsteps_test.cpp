// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tuning/nextsteps.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using Distances = std::vector<std::int32_t>;

TEST(StepsToFindAMotorFrom, GoBothWaysInTwoSizesAndEndWhereTheyBegan) {
    EXPECT_EQ(stepSeries(100), (Distances{100, -100, 200, -200}));
    EXPECT_EQ(stepSeries(-100), (Distances{-100, 100, -200, 200}));
}

/// The longest step is 2000 counts.
TEST(StepsToFindAMotorFrom, AreNeverTooLong) {
    EXPECT_EQ(stepSeries(1'000), (Distances{1'000, -1'000, 2'000, -2'000}));
    EXPECT_EQ(stepSeries(1'500), (Distances{1'000, -1'000, 2'000, -2'000}));
    EXPECT_EQ(stepSeries(-2'000), (Distances{-1'000, 1'000, -2'000, 2'000}));
}

TEST(StepsToFindAMotorFrom, TellMuchBothWaysInTwoSizes) {
    EXPECT_FALSE(informative({}));
    EXPECT_FALSE(informative(Distances{100}));
    EXPECT_FALSE(informative(Distances{100, 200})) << "both go one way";
    EXPECT_FALSE(informative(Distances{-100, -200}));
    EXPECT_FALSE(informative(Distances{100, -100})) << "they have the same size";
    EXPECT_FALSE(informative(Distances{100, -110})) << "these are hardly two sizes";
    EXPECT_TRUE(informative(Distances{100, -200}));
    EXPECT_TRUE(informative(stepSeries(7)));
}

TEST(StepsToFindAMotorFrom, GoOnBackAndThenByTheOtherSize) {
    Distances made = stepSeries(100);
    for (const std::int32_t next : {100, -100, 200, -200, 100}) {
        EXPECT_EQ(nextStep(made), next);
        made.push_back(next);
        made.erase(made.begin());
    }
    EXPECT_EQ(nextStep(Distances{-50, 50, -100, 100}), -50)
        << "it continues in the direction in which the series began";
}

}  // namespace
}  // namespace nmc
