// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises a servo that should hold but swings, from positions calculated by closed forms.
#include "model/module/swingwatch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace nmc {
namespace {

using namespace std::chrono_literals;

/// The swing found after looking at `position` for `seconds`, about every `between` seconds and unevenly,
/// like a bus.
std::optional<SwingWatch::Swing> seen(const std::function<double(double)>& position, double between = 0.0107,
                                      double seconds = 1.5) {
    SwingWatch watch;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(0.9, 1.1);
    for (double t = 0; t < seconds; t += between * jitter(random))
        watch.look(TimePoint(1s) + fromSeconds(t), static_cast<std::int32_t>(std::lround(position(t))));
    return watch.swing();
}

std::function<double(double)> sine(double amplitude, double hertz, double about = 0) {
    return [=](double t) { return about + amplitude * std::sin(2 * std::numbers::pi * hertz * t + 0.4); };
}

TEST(SwingWatch, TellsHowFarAndHowFast) {
    for (const double hertz : {3.0, 12.0, 37.0})
        for (const double about : {0.0, -70'000.0}) {
            const auto swing = seen(sine(200, hertz, about));
            ASSERT_TRUE(swing && swing->hertz) << hertz;
            EXPECT_NEAR(swing->amplitude, 200, 10) << hertz;
            EXPECT_NEAR(*swing->hertz, hertz, 0.3) << hertz;
        }
}

TEST(SwingWatch, AFewCountsAreNone) {
    EXPECT_FALSE(seen(sine(6, 12)));
    EXPECT_TRUE(seen(sine(12, 12)));
}

TEST(SwingWatch, WhatCalmsDownIsNone) {
    EXPECT_FALSE(seen([](double t) { return 300 * std::exp(-4 * t) * std::cos(60 * t); }));
}

TEST(SwingWatch, ACreepOrAJumpIsNone) {
    EXPECT_FALSE(seen([](double t) { return 500 * t; }));
    EXPECT_FALSE(seen([](double t) { return t < 1.2 ? 0.0 : 300.0; }));
    EXPECT_FALSE(seen([](double t) { return t > 1.0 && t < 1.25 ? 300.0 : 0.0; })) << "only once to and fro";
}

TEST(SwingWatch, LookedAtRarelyTheRateIsNotTold) {
    const auto swing = seen(sine(200, 37), 0.17, 4);
    ASSERT_TRUE(swing);
    EXPECT_FALSE(swing->hertz);
    EXPECT_GT(swing->amplitude, 100);
    EXPECT_LE(swing->amplitude, 200);
}

/// To and fro by 4 counts every 2 s, which is more than the one count of the encoder.
TEST(SwingWatch, TellsAMotorThatHunts) {
    const auto hunts = [](double t) { return std::fmod(t, 2.0) < 1.0 ? 2.0 : -2.0; };
    EXPECT_FALSE(seen(hunts, 0.01, 3.5)) << "only twice to and fro";
    const auto swing = seen(hunts, 0.01, 8);
    ASSERT_TRUE(swing && swing->hertz);
    EXPECT_TRUE(swing->hunts);
    EXPECT_NEAR(swing->amplitude, 2, 0.01);
    EXPECT_NEAR(1 / *swing->hertz, 2.0, 0.1);
    EXPECT_FALSE(seen([&](double t) { return t < 8 ? hunts(t) : 2.0; }, 0.01, 14)) << "it has come to rest";
    EXPECT_FALSE(seen([](double t) { return std::fmod(t, 2.0) < 1.0 ? 1.0 : -1.0; }, 0.01, 8))
        << "an encoder between two counts";
}

TEST(SwingWatch, IsOverWhenItIs) {
    SwingWatch watch;
    const auto swings = sine(200, 12);
    for (int i = 0; i < 300; ++i) {
        const double t = i * 0.01;
        watch.look(TimePoint(1s) + fromSeconds(t), static_cast<std::int32_t>(t < 1.5 ? swings(t) : 0));
        if (i == 149) {
            EXPECT_TRUE(watch.swing());
        }
    }
    EXPECT_FALSE(watch.swing());
    watch.look(TimePoint(20s), 5);
    watch.forget();
    EXPECT_FALSE(watch.swing());
}

}  // namespace
}  // namespace nmc
