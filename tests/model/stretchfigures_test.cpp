// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a signal between two cursors, compared with closed forms.
#include "model/scope/stretchfigures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace nmc {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Points from 0 to `end` s.
template <typename Value>
std::vector<SignalPoint> points(double end, Value value, double perSecond = 1'000) {
    std::vector<SignalPoint> made;
    for (int i = 0; i <= std::lround(end * perSecond); ++i)
        made.push_back({i / perSecond, value(i / perSecond), i > 0});
    return made;
}

TEST(StretchFigures, OfASine) {
    const auto figures = figuresOf(points(2, [](double t) { return 20 + 100 * std::sin(kTurn * 5 * t); }));
    ASSERT_TRUE(figures.has_value());
    EXPECT_NEAR(figures->mean, 20, 1e-9);
    EXPECT_NEAR(figures->rms, std::sqrt(20.0 * 20 + 100.0 * 100 / 2), 0.01);
    EXPECT_NEAR(figures->peakToPeak, 200, 1e-9);
    ASSERT_TRUE(figures->hertz.has_value());
    EXPECT_NEAR(*figures->hertz, 5, 0.02);
}

TEST(StretchFigures, OfARamp) {
    const auto figures = figuresOf(points(10, [](double t) { return 3 * t; }));
    ASSERT_TRUE(figures.has_value());
    EXPECT_NEAR(figures->mean, 15, 1e-9);
    EXPECT_NEAR(figures->rms, std::sqrt(300.0), 1e-6);  // 9 t^2, whose mean over 10 s is 300
    EXPECT_NEAR(figures->peakToPeak, 30, 1e-9);
    ASSERT_TRUE(figures->slope.has_value());
    EXPECT_NEAR(*figures->slope, 3, 1e-9);
    EXPECT_FALSE(figures->hertz.has_value());
}

TEST(StretchFigures, OfWhatStandsStill) {
    const auto figures = figuresOf(points(1, [](double) { return -7.0; }));
    ASSERT_TRUE(figures.has_value());
    EXPECT_NEAR(figures->mean, -7, 1e-12);
    EXPECT_NEAR(figures->rms, 7, 1e-12);
    EXPECT_EQ(figures->peakToPeak, 0);
    ASSERT_TRUE(figures->slope.has_value());
    EXPECT_NEAR(*figures->slope, 0, 1e-12);
    EXPECT_FALSE(figures->hertz.has_value());
}

/// 9 s at 0, then up to 10 in 1 s.
TEST(StretchFigures, TimeCountsAndNotTheNumberOfPoints) {
    const auto figures = figuresOf({{0, 0, false}, {9, 0, true}, {10, 10, true}});
    ASSERT_TRUE(figures.has_value());
    EXPECT_NEAR(figures->mean, 0.5, 1e-12);
    EXPECT_NEAR(figures->rms, std::sqrt(100.0 / 3 / 10), 1e-12);
}

TEST(StretchFigures, AGapCountsForNothing) {
    const auto figures =
        figuresOf({{0, 10, false}, {1, 10, true}, {5, 20, false}, {6, 20, true}, {100, 0, false}});
    ASSERT_TRUE(figures.has_value());
    EXPECT_NEAR(figures->mean, 15, 1e-12);
    EXPECT_NEAR(figures->rms, std::sqrt((100.0 + 400.0) / 2), 1e-12);
}

TEST(StretchFigures, OfOnePointAndOfNone) {
    EXPECT_FALSE(figuresOf({}).has_value());
    const auto one = figuresOf({{3, 5, true}});
    ASSERT_TRUE(one.has_value());
    EXPECT_EQ(one->mean, 5);
    EXPECT_EQ(one->rms, 5);
    EXPECT_EQ(one->peakToPeak, 0);
    EXPECT_FALSE(one->slope.has_value());
}

TEST(StretchFigures, FrequencyWhateverTheDutyCycleAndTheTrend) {
    const auto square = [](double t) { return std::fmod(t * 2, 1.0) < 0.2 ? 1.0 : -1.0; };
    const auto onARamp = [](double t) { return 500 * t + 10 * std::sin(kTurn * 8 * t); };
    const auto a = figuresOf(points(5, square));
    const auto b = figuresOf(points(5, onARamp));
    ASSERT_TRUE(a && a->hertz && b && b->hertz);
    EXPECT_NEAR(*a->hertz, 2, 0.02);
    EXPECT_NEAR(*b->hertz, 8, 0.05);
}

TEST(StretchFigures, FrequencyOfThreePeriodsFromAnyPhase) {
    for (double phase = 0; phase < kTurn; phase += 0.1) {
        const auto figures =
            figuresOf(points(3.0 / 20, [&](double t) { return std::sin(kTurn * 20 * t + phase); }));
        ASSERT_TRUE(figures && figures->hertz) << phase;
        EXPECT_NEAR(*figures->hertz, 20, 0.6) << phase;
    }
}

/// Counts are whole numbers: a slow ramp rises in steps at a certain rate, but does not swing.
TEST(StretchFigures, RoundingIsNoSwing) {
    const auto stairs = points(4, [](double t) { return std::floor(10 * t); });
    EXPECT_FALSE(figuresOf(stairs, 1)->hertz.has_value());
    const auto swing = points(4, [](double t) { return std::round(3 * std::sin(kTurn * 10 * t)); });
    ASSERT_TRUE(figuresOf(swing, 1)->hertz.has_value());
    EXPECT_NEAR(*figuresOf(swing, 1)->hertz, 10, 0.1);
}

TEST(StretchFigures, NoFrequencyWhereThereIsNone) {
    std::uint32_t state = 1;
    const auto noise = [&](double) {
        state = state * 1'664'525U + 1'013'904'223U;
        return static_cast<double>(state >> 16U);
    };
    const auto hertz = [](const std::vector<SignalPoint>& of) { return figuresOf(of)->hertz; };
    EXPECT_FALSE(hertz(points(5, noise)).has_value());
    EXPECT_FALSE(hertz(points(0.25, [](double t) { return std::sin(kTurn * 5 * t); })).has_value())
        << "only one and a quarter periods";
    EXPECT_FALSE(hertz(points(1, [](double t) { return std::cos(std::numbers::pi * std::round(t * 1'000)); }))
                     .has_value())
        << "as fast as the samples, so the true frequency is unknown";
    EXPECT_FALSE(hertz(points(2, [](double t) { return t < 1 ? 0.0 : 1.0; })).has_value()) << "a step";
    EXPECT_FALSE(hertz(points(2, [](double t) { return std::sin(kTurn * (3 * t + 6 * t * t)); })).has_value())
        << "its frequency keeps rising";
}

}  // namespace
}  // namespace nmc
