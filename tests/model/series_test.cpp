// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/series.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "servofixture.h"

namespace nmc {
namespace {

using testing_support::atSeconds;

std::size_t pointsIn(const std::vector<Series::Segment>& segments) {
    std::size_t count = 0;
    for (const auto& segment : segments)
        count += segment.size();
    return count;
}

TEST(Series, KeepsTheNewestWhenItIsFull) {
    Series series(3);
    for (int i = 0; i < 5; ++i)
        series.append(atSeconds(i), i);
    EXPECT_EQ(series.size(), 3U);
    const auto window = series.window(atSeconds(0), atSeconds(10), 1'000);
    ASSERT_EQ(window.size(), 1U);
    EXPECT_EQ(window[0].front().value, 2.0);
    EXPECT_EQ(series.last()->value, 4.0);
}

TEST(Series, NeverConnectsAcrossAGap) {
    Series series;
    series.append(atSeconds(1), 10);
    series.append(atSeconds(2), 11);
    series.breakHere();
    series.append(atSeconds(8), 12);
    const auto window = series.window(atSeconds(0), atSeconds(10), 5);
    ASSERT_EQ(window.size(), 2U);
    EXPECT_EQ(window[0].size(), 2U);
    EXPECT_EQ(window[1].size(), 1U);
}

TEST(Series, DoesNotConnectAcrossAGapWithinOneColumn) {
    Series series;
    series.append(atSeconds(1.0), 10);
    series.breakHere();
    series.append(atSeconds(1.001), 12);
    EXPECT_EQ(series.window(atSeconds(0), atSeconds(10), 5).size(), 2U);
}

TEST(Series, ReachesOnePointBeyondEachEndSoThatLinesReachTheEdge) {
    Series series;
    for (int i = 0; i < 10; ++i)
        series.append(atSeconds(i), i);
    const auto window = series.window(atSeconds(3.5), atSeconds(5.5), 1'000);
    ASSERT_EQ(window.size(), 1U);
    EXPECT_EQ(window[0].front().value, 3.0);
    EXPECT_EQ(window[0].back().value, 6.0);
}

TEST(Series, IsEmptyForAnEmptyWindow) {
    Series series;
    EXPECT_TRUE(series.window(atSeconds(0), atSeconds(1), 100).empty());
    series.append(atSeconds(1), 1);
    EXPECT_TRUE(series.window(atSeconds(1), atSeconds(1), 100).empty());
    EXPECT_TRUE(series.window(atSeconds(0), atSeconds(2), 0).empty());
}

TEST(Series, ASpikeOfOneSampleSurvivesEveryZoom) {
    Series series;
    for (int i = 0; i < 100'000; ++i)
        series.append(atSeconds(i * 1e-3), i == 54'321 ? 1e6 : 0.0);
    for (const std::size_t columns : {1U, 7U, 100U, 1'200U}) {
        double highest = 0;
        for (const auto& segment : series.window(atSeconds(0), atSeconds(100), columns))
            for (const SeriesPoint& point : segment)
                highest = std::max(highest, point.value);
        EXPECT_EQ(highest, 1e6) << columns;
    }
}

RC_GTEST_PROP(Series, DrawsFewPointsButAllExtremes, (std::vector<std::int16_t> values)) {
    Series series;
    for (std::size_t i = 0; i < values.size(); ++i)
        series.append(atSeconds(static_cast<double>(i)), values[i]);
    const std::size_t columns = *rc::gen::inRange<std::size_t>(1, 50);
    const auto window =
        series.window(atSeconds(-1), atSeconds(static_cast<double>(values.size()) + 1), columns);
    RC_PRE(!values.empty());
    RC_ASSERT(window.size() == 1U);
    RC_ASSERT(pointsIn(window) <= 4 * (columns + 2));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const auto byValue = [](const SeriesPoint& a, const SeriesPoint& b) { return a.value < b.value; };
    const auto [drawnLow, drawnHigh] = std::minmax_element(window[0].begin(), window[0].end(), byValue);
    RC_ASSERT(drawnLow->value == static_cast<double>(*low));
    RC_ASSERT(drawnHigh->value == static_cast<double>(*high));
    RC_ASSERT(std::is_sorted(window[0].begin(), window[0].end(),
                             [](const SeriesPoint& a, const SeriesPoint& b) { return a.time < b.time; }));
}

}  // namespace
}  // namespace nmc
