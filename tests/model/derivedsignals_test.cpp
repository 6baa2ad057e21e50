// SPDX-License-Identifier: GPL-3.0-or-later
// Signals that are derived from samples: the acceleration, and the PWM value that the control filter sent to
// the amplifier.
#include "model/scope/derivedsignals.h"

#include <gtest/gtest.h>

#include <functional>

#include "servofixture.h"
#include "tests/support/servotick.h"

namespace nmc {
namespace {

using testing_support::atSeconds;
using testing_support::kTick;

constexpr ModuleIndex kModule(0);
constexpr double kInterval = 4 * kTick;

servo::SetGain gains(std::uint16_t kp, std::uint16_t kd, std::uint16_t ki, std::uint16_t il) {
    return {kp, kd, ki, il, 255, 0, 16'000, 1, std::uint8_t{0}};
}

/// Samples of a servo that is on, one every 4 ticks.
History historyOf(int count, const std::optional<servo::SetGain>& set,
                  const std::function<void(int, ScopeSample&)>& fill) {
    History history(1);
    history.noteGains({kModule, atSeconds(0), set});
    for (int i = 0; i < count; ++i) {
        ScopeSample sample;
        sample.time = atSeconds(i * kInterval);
        sample.aux = 0x04;
        fill(i, sample);
        history.append(kModule, sample);
    }
    return history;
}

void setError(ScopeSample& sample, double error, double half = 0) {
    sample.error = static_cast<float>(error);
    sample.errorLow = static_cast<float>(error - half);
    sample.errorHigh = static_cast<float>(error + half);
}

/// The values of the derived signal, each in the error of a sample.
std::vector<ScopeSample> derived(const History& history, ScopeSignal signal) {
    DerivedSignals signals;
    signals.want({{kModule, signal}});
    EXPECT_TRUE(signals.follow(history));
    const auto source = signals.source(history, {kModule, signal});
    EXPECT_EQ(source.signal, ScopeSignal::Error);
    return source.samples->samples(TimePoint::min(), TimePoint::max());
}

void expectPwm(const ScopeSample& sample, double low, double likely, double high) {
    EXPECT_EQ(sample.errorLow, static_cast<float>(low));
    EXPECT_EQ(sample.error, static_cast<float>(likely));
    EXPECT_EQ(sample.errorHigh, static_cast<float>(high));
}

// ---- acceleration ----

TEST(DerivedAcceleration, OfAParabolaIsExact) {
    // i^2 counts every 2 ms: 2 / (0.002 s)^2.
    History history(1);
    for (int i = 0; i < 100; ++i) {
        ScopeSample sample;
        sample.time = atSeconds(i * 0.002);
        sample.position = i * i;
        history.append(kModule, sample);
    }
    const auto values = derived(history, ScopeSignal::Acceleration);
    ASSERT_EQ(values.size(), 80U) << "40 ms of the samples have no value";
    for (const ScopeSample& value : values)
        expectPwm(value, 500'000, 500'000, 500'000);
}

/// For a cubic, the value is the acceleration in the middle of the window, and is given for that time.
TEST(DerivedAcceleration, BelongsToTheMomentThatItIsOf) {
    History history(1);
    for (int i = 0; i < 100; ++i) {
        ScopeSample sample;
        sample.time = atSeconds(i * 0.002);
        sample.position = i * i * i;
        history.append(kModule, sample);
    }
    const auto values = derived(history, ScopeSignal::Acceleration);
    ASSERT_EQ(values.size(), 80U) << "as of a parabola";
    for (const ScopeSample& value : values) {
        const double i = toSeconds(value.time - atSeconds(0)) / 0.002;
        EXPECT_NEAR(static_cast<double>(value.error), 6 * i / (0.002 * 0.002), 20);
    }
}

TEST(DerivedAcceleration, IsNotTakenAcrossAGap) {
    History history(1);
    for (int i = 0; i < 100; ++i) {
        ScopeSample sample;
        sample.time = atSeconds(i * 0.002);
        sample.position = i < 50 ? 0 : 100'000;
        sample.gapBefore = i == 50;
        history.append(kModule, sample);
    }
    const auto values = derived(history, ScopeSignal::Acceleration);
    ASSERT_EQ(values.size(), 60U);
    for (const ScopeSample& value : values)
        EXPECT_EQ(value.error, 0);
    EXPECT_TRUE(values[30].gapBefore);
    EXPECT_FALSE(values[31].gapBefore);
}

// ---- PWM (DS-V 4.3) ----

TEST(DerivedPwm, OfAStandingErrorIsTheProportionalPartExactly) {
    const auto values = derived(
        historyOf(50, gains(512, 1'000, 0, 0), [](int, auto& s) { setError(s, -30); }), ScopeSignal::Pwm);
    ASSERT_EQ(values.size(), 49U) << "the last sample waits for the next one";
    for (const ScopeSample& value : values)
        expectPwm(value, -60, -60, -60);
}

TEST(DerivedPwm, HasTheErrorsBand) {
    const auto values = derived(historyOf(9, gains(256, 0, 0, 0), [](int, auto& s) { setError(s, 50, 2); }),
                                ScopeSignal::Pwm);
    ASSERT_FALSE(values.empty());
    expectPwm(values[3], 48, 50, 52);
}

/// The error grows by a count in every tick, which rounding to counts may turn into 0 or 2.
TEST(DerivedPwm, OfAnErrorThatGrowsHasTheDampingPart) {
    const auto values = derived(
        historyOf(9, gains(0, 2'560, 0, 0), [](int i, auto& s) { setError(s, 4 * i); }), ScopeSignal::Pwm);
    ASSERT_FALSE(values.empty());
    expectPwm(values[3], 0, 10, 20);
}

TEST(DerivedPwm, IsLimitedAndThenDeadbandIsAdded) {
    servo::SetGain limited = gains(256, 0, 0, 0);
    limited.ol = 127;
    limited.db = 20;
    const auto fill = [](int i, ScopeSample& s) { setError(s, i < 10 ? 200 : i < 20 ? 0.5 : -1'000); };
    const auto values = derived(historyOf(30, limited, fill), ScopeSignal::Pwm);
    ASSERT_EQ(values.size(), 29U);
    expectPwm(values[5], 147, 147, 147);
    expectPwm(values[15], 0, 0, 0);  // less than one count of PWM is 0, and gets no deadband
    expectPwm(values[25], -147, -147, -147);
}

/// The initial integral is unknown. It grows by 256 counts a tick until IL limits it to 100 times 256; from
/// the lowest possible value, this takes 200 ticks.
TEST(DerivedPwm, LearnsTheIntegralWhereItsLimitCutsItOff) {
    const auto values = derived(historyOf(100, gains(0, 0, 256, 100), [](int, auto& s) { setError(s, 256); }),
                                ScopeSignal::Pwm);
    ASSERT_EQ(values.size(), 99U);
    expectPwm(values[0], -100, 0, 100);
    expectPwm(values[25], 0, 100, 100);
    expectPwm(values[50], 100, 100, 100);
}

TEST(DerivedPwm, MayBeAnythingDownToNothingWhileTheCurrentIsLimited) {
    servo::SetGain limited = gains(256, 0, 0, 0);
    limited.cl = 101;
    const auto fill = [](int i, ScopeSample& s) {
        setError(s, 50);
        s.status = i < 10 ? 0x00 : 0x04;
    };
    const auto values = derived(historyOf(20, limited, fill), ScopeSignal::Pwm);
    expectPwm(values[5], 50, 50, 50);
    expectPwm(values[15], 0, 50, 50);
}

TEST(DerivedPwm, IsNotKnownWithoutGainsErrorOrServo) {
    const auto standing = [](int, ScopeSample& s) { setError(s, 10); };
    EXPECT_TRUE(derived(historyOf(20, std::nullopt, standing), ScopeSignal::Pwm).empty());
    EXPECT_TRUE(derived(historyOf(20, gains(256, 0, 0, 0), [](int, auto&) {}), ScopeSignal::Pwm).empty());
    const auto offInBetween = [](int i, ScopeSample& s) {
        setError(s, 10);
        if (i >= 8 && i < 12)
            s.aux = 0;
    };
    const auto values = derived(historyOf(20, gains(256, 0, 0, 0), offInBetween), ScopeSignal::Pwm);
    ASSERT_EQ(values.size(), 8U + 7U);
    EXPECT_TRUE(values[8].gapBefore);
    EXPECT_FALSE(values[9].gapBefore);
}

TEST(DerivedPwm, FollowsNewGains) {
    History history = historyOf(20, gains(256, 0, 0, 0), [](int, auto& s) { setError(s, 10); });
    history.noteGains({kModule, atSeconds(20 * kInterval), gains(512, 0, 0, 0)});
    for (int i = 20; i < 40; ++i) {
        ScopeSample sample;
        sample.time = atSeconds(i * kInterval);
        sample.aux = 0x04;
        setError(sample, 10);
        history.append(kModule, sample);
    }
    const auto values = derived(history, ScopeSignal::Pwm);
    ASSERT_EQ(values.size(), 39U);
    expectPwm(values[19], 10, 10, 10);
    expectPwm(values[20], 20, 20, 20);
}

// ---- all of them ----

TEST(DerivedSignals, CostNothingUnlessTheyAreWanted) {
    const History history = historyOf(100, gains(256, 0, 0, 0), [](int, auto& s) { setError(s, 10); });
    DerivedSignals signals;
    const ModuleSignal pwm{kModule, ScopeSignal::Pwm};
    const ModuleSignal position{kModule, ScopeSignal::Position};
    signals.want({position});
    EXPECT_TRUE(signals.follow(history));
    EXPECT_EQ(signals.source(history, pwm).samples, nullptr);
    EXPECT_EQ(signals.source(history, position).samples, history.module(kModule))
        << "a signal of the samples themselves";
    signals.want({position, pwm});
    EXPECT_TRUE(signals.follow(history));
    EXPECT_EQ(signals.source(history, pwm).samples->count(), 99U);
    signals.want({position});
    EXPECT_EQ(signals.source(history, pwm).samples, nullptr);
}

/// However long the history is, no frame waits for all of it; later samples are appended.
TEST(DerivedSignals, CatchUpInPieces) {
    const auto standing = [](int, ScopeSample& s) { setError(s, 10); };
    const int count = 2 * static_cast<int>(DerivedSignals::kAtOnce) + 10;
    History history = historyOf(count, gains(256, 0, 0, 0), standing);
    DerivedSignals signals;
    const ModuleSignal pwm{kModule, ScopeSignal::Pwm};
    signals.want({pwm});
    EXPECT_FALSE(signals.follow(history));
    EXPECT_FALSE(signals.follow(history));
    EXPECT_TRUE(signals.follow(history));
    EXPECT_EQ(signals.source(history, pwm).samples->count(), static_cast<std::uint64_t>(count) - 1);
    ScopeSample next;
    next.time = atSeconds(count * kInterval);
    next.aux = 0x04;
    setError(next, 10);
    history.append(kModule, next);
    EXPECT_TRUE(signals.follow(history));
    EXPECT_EQ(signals.source(history, pwm).samples->count(), static_cast<std::uint64_t>(count));
    EXPECT_FALSE(signals.source(history, pwm).samples->last()->gapBefore);
    signals.forget();
    EXPECT_EQ(signals.source(history, pwm).samples->count(), 0U);
}

}  // namespace
}  // namespace nmc
