// SPDX-License-Identifier: GPL-3.0-or-later
// Sines that grow, stay or decay, sampled every 1.6 ms, as positions of a servo on which gains are tried.
#include "bus/trialwatch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace nmc::bus {
namespace {

constexpr std::int32_t kStood = -1'000;
constexpr GainTrial kTrial{{}, kStood, 2'000, std::chrono::seconds(10)};

[[nodiscard]] servo::SetGain gainsOf(std::uint16_t kp, std::uint8_t ol) {
    return {kp, 0, 0, 0, ol, 0, 4'000, 1, std::uint8_t{0}};
}

struct End {
    double seconds;
    TrialEnd why;
};

/// The end of a trial, if it ends within two seconds. `off`: distance in counts from the first position, by
/// time in seconds.
[[nodiscard]] std::optional<End> endOf(const std::function<double(double)>& off,
                                       const servo::SetGain& gains = gainsOf(10, 255)) {
    TrialWatch watch(gains, kTrial);
    for (double t = 0; t < 2; t += 1.6e-3) {
        const auto position = kStood + static_cast<std::int32_t>(std::floor(off(t)));
        if (const auto why = watch.look(TimePoint{} + fromSeconds(1 + t), position))
            return End{t, *why};
    }
    return std::nullopt;
}

[[nodiscard]] std::function<double(double)> swing(double counts, double hertz, double ofEach) {
    return [=](double t) {
        const double turn = 2 * std::numbers::pi * hertz;
        return counts * std::pow(ofEach, 2 * hertz * t) * std::sin(turn * t);
    };
}

/// Each half cycle is twice as wide as the one before: starting from 6 counts, the third leaves no doubt.
TEST(TrialWatch, EndsAtTheThirdHalfCycleOfASwingThatGrows) {
    for (const double hertz : {5.0, 30.0, 80.0}) {
        const auto end = endOf(swing(6, hertz, 2));
        ASSERT_TRUE(end) << hertz;
        EXPECT_EQ(end->why, TrialEnd::Swings);
        EXPECT_GT(end->seconds, 1.0 / hertz) << hertz;
        EXPECT_LE(end->seconds, 1.5 / hertz) << hertz;
    }
}

TEST(TrialWatch, EndsASwingThatStaysAtItsThirdHalfCycle) {
    for (const double hertz : {2.0, 10.0, 60.0}) {
        const auto end = endOf(swing(12, hertz, 1));
        ASSERT_TRUE(end) << hertz;
        EXPECT_EQ(end->why, TrialEnd::Swings);
        EXPECT_GE(end->seconds, 1.0 / hertz) << hertz;
        EXPECT_LE(end->seconds, 1.25 / hertz + 1.6e-3) << hertz;
    }
}

/// A stable loop that was pushed calms down: each half cycle is exp(-pi zeta / sqrt(1 - zeta^2)) of the one
/// before, 0.53 for a zeta of 0.2.
TEST(TrialWatch, LeavesAloneWhatCalmsDown) {
    for (const double hertz : {5.0, 30.0, 120.0})
        for (const double zeta : {0.2, 0.5, 0.7})
            for (const double counts : {5.0, 40.0, 300.0}) {
                const double ofEach = std::exp(-std::numbers::pi * zeta / std::sqrt(1 - zeta * zeta));
                EXPECT_FALSE(endOf(swing(counts, hertz, ofEach))) << hertz << " Hz, zeta " << zeta;
            }
}

TEST(TrialWatch, LeavesAloneWhatCreepsAndWhatIsPushedSlowly) {
    EXPECT_FALSE(endOf([](double t) { return -6 * t; })) << "friction and Ki, by up to 12 counts";
    EXPECT_FALSE(endOf([](double t) { return std::fmod(t * 500, 2); })) << "to and fro by a count";
    // A hand pushes it by 30 counts in half a second and lets go, and it returns with an overshoot of 3.
    EXPECT_FALSE(endOf([](double t) {
        return t < 0.5 ? 60 * t : 33 * std::exp(-40 * (t - 0.5)) * std::cos(60 * (t - 0.5));
    }));
    // It creeps by 3 counts one way, and is then hit the other way.
    EXPECT_FALSE(endOf([](double t) {
        return t < 1 ? -3 * t : -3 + 30 * std::exp(-80 * (t - 1)) * std::sin(150 * (t - 1));
    }));
}

/// The error alone requires more than OL: 1000 e / 256 > 100 from 25.6 counts on (DS-V 4.3).
TEST(TrialWatch, EndsWhereTheOutputLimitIsReached) {
    EXPECT_FALSE(endOf([](double) { return 25.0; }, gainsOf(1'000, 100)));
    const auto end = endOf([](double) { return -26.0; }, gainsOf(1'000, 100));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->why, TrialEnd::Saturates);
    EXPECT_EQ(end->seconds, 0.0);
}

TEST(TrialWatch, EndsTooFarAway) {
    EXPECT_FALSE(endOf([](double) { return 2'000.0; }));
    const auto end = endOf([](double) { return -2'001.0; });
    ASSERT_TRUE(end);
    EXPECT_EQ(end->why, TrialEnd::TooFar);
}

/// Positions of 32 bits wrap.
TEST(TrialWatch, CountsAcrossTheEndOfTheCounter) {
    TrialWatch watch(gainsOf(10, 255), {{}, std::numeric_limits<std::int32_t>::max(), 100, {}});
    EXPECT_FALSE(watch.look(TimePoint{}, std::numeric_limits<std::int32_t>::min() + 99));
    EXPECT_EQ(watch.look(TimePoint{}, std::numeric_limits<std::int32_t>::min() + 100), TrialEnd::TooFar);
}

}  // namespace
}  // namespace nmc::bus
