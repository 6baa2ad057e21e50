// SPDX-License-Identifier: GPL-3.0-or-later
// The user's own signals: sums of two signals at times of their own, scaled and filtered.
#include "model/scope/customsignal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/scope/derivedsignals.h"
#include "servofixture.h"

namespace nmc {
namespace {

using testing_support::atSeconds;

constexpr ModuleIndex kA(0), kB(1);
constexpr ModuleSignal kCustom{kA, ScopeSignal::Custom1};
constexpr ModuleSignal kPositionOfA{kA, ScopeSignal::Position};
constexpr ModuleSignal kPositionOfB{kB, ScopeSignal::Position};

class CustomSignals : public testing::Test {
protected:
    History history{2};
    DerivedSignals derived;

    void add(ModuleIndex module, double seconds, std::int32_t position, bool gapBefore = false) {
        ScopeSample sample;
        sample.time = atSeconds(seconds);
        sample.position = position;
        sample.gapBefore = gapBefore;
        history.append(module, sample);
    }
    std::vector<ScopeSample> values(const CustomSignal& how) {
        derived.want({how.of}, {how});
        EXPECT_TRUE(derived.follow(history));
        const SignalSource source = derived.source(history, how.of);
        EXPECT_EQ(source.signal, ScopeSignal::Error);
        return source.samples != nullptr ? source.samples->samples(TimePoint::min(), TimePoint::max())
                                         : std::vector<ScopeSample>{};
    }
};

TEST_F(CustomSignals, OneSignalIsScaled) {
    add(kA, 0, 40);
    add(kA, 1, -8);
    const auto scaled = values({kCustom, {kPositionOfA, {0.5, -10}}});
    ASSERT_EQ(scaled.size(), 2U);
    EXPECT_EQ(scaled[0].error, 10) << "40 x 0.5 - 10";
    EXPECT_EQ(scaled[1].error, -14);
    EXPECT_TRUE(scaled[0].gapBefore);
    EXPECT_FALSE(scaled[1].gapBefore);
    EXPECT_EQ(scaled[1].errorLow, scaled[1].errorHigh);
}

/// What is kept of the values of one definition, such as their mean, is not that of another.
TEST_F(CustomSignals, AnotherDefinitionIsAnotherSource) {
    const auto sourceOf = [this](double factor) {
        derived.want({kCustom}, {{kCustom, {kPositionOfA, {factor, 0}}}});
        return derived.source(history, kCustom);
    };
    const SignalSource first = sourceOf(1);
    EXPECT_EQ(sourceOf(1), first);
    EXPECT_NE(sourceOf(2), first);
    EXPECT_NE(sourceOf(1), first) << "it starts from nothing again";
}

/// The samples of two modules never have the same time.
TEST_F(CustomSignals, ADifferenceOfTwoModulesIsTakenAtTheSameTime) {
    for (int i = 0; i < 20; ++i) {
        add(kA, 0.010 * i, 100 * i);
        add(kB, 0.010 * i + 0.005, 40 * i + 20);
    }
    const auto differences = values({kCustom, {kPositionOfA}, CustomSignal::Part{kPositionOfB, {-1, 0}}});
    ASSERT_EQ(differences.size(), 19U) << "at the first time, B is unknown";
    for (std::size_t i = 0; i < differences.size(); ++i) {
        EXPECT_EQ(differences[i].time, atSeconds(0.010 * static_cast<double>(i + 1)));
        EXPECT_NEAR(differences[i].error, 60.0 * static_cast<double>(i + 1), 1e-3);
    }
}

TEST_F(CustomSignals, AValueWaitsForTheSampleOfTheOtherModule) {
    const CustomSignal sum{kCustom, {kPositionOfA}, CustomSignal::Part{kPositionOfB, {}}};
    add(kB, 0, 0);
    add(kA, 1, 5);
    EXPECT_TRUE(values(sum).empty());
    add(kB, 2, 40);
    const auto made = values(sum);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].error, 25) << "5, and 20 halfway from 0 to 40";
}

TEST_F(CustomSignals, WhereTheOtherModuleHasAGapSoHasTheSum) {
    for (int i = 0; i < 10; ++i) {
        add(kA, i, 1);
        add(kB, i + 0.5, 2, i == 5);
    }
    const auto made = values({kCustom, {kPositionOfA}, CustomSignal::Part{kPositionOfB, {}}});
    ASSERT_EQ(made.size(), 8U) << "unknown at 0 s, and at 5 s";
    for (const ScopeSample& value : made)
        EXPECT_EQ(value.gapBefore, value.time == atSeconds(1) || value.time == atSeconds(6));
}

TEST_F(CustomSignals, AnUnknownErrorHasNoValue) {
    add(kA, 0, 1);
    EXPECT_TRUE(values({kCustom, {{kA, ScopeSignal::Error}, {}}}).empty());
}

/// A step through the filter: 1 - exp(-2 pi f t), at whatever times the samples come.
TEST_F(CustomSignals, TheFilterAnswersAStepWithAnExponential) {
    constexpr double kCutoff = 5;
    for (const double before : {-0.02, -0.01})
        add(kA, before + 1, 0);
    const std::array times{0.0, 0.001, 0.004, 0.020, 0.021, 0.050, 0.100};
    for (const double time : times)
        add(kA, time + 1, 1'000);
    const auto filtered = values({kCustom, {kPositionOfA}, {}, kCutoff});
    ASSERT_EQ(filtered.size(), times.size() + 2);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double since = times[i] + 0.01;  // the last sample before the step
        EXPECT_NEAR(filtered[i + 2].error, 1'000 * (1 - std::exp(-2 * std::numbers::pi * kCutoff * since)),
                    1e-2);
    }
}

TEST_F(CustomSignals, ASineAtTheCutoffIsPassedByOneOverRootTwo) {
    constexpr double kHertz = 5;
    constexpr double kInterval = 0.0005;
    for (int i = 0; i < 4'000; ++i)
        add(kA, kInterval * i,
            static_cast<std::int32_t>(
                std::lround(100'000 * std::sin(2 * std::numbers::pi * kHertz * kInterval * i))));
    double highest = 0;
    for (const ScopeSample& value : values({kCustom, {kPositionOfA}, {}, kHertz}))
        if (value.time > atSeconds(1))
            highest = std::max(highest, static_cast<double>(value.error));
    EXPECT_NEAR(highest, 100'000 / std::numbers::sqrt2, 700) << "1 % for the distance of the samples";
}

TEST_F(CustomSignals, TheFilterBeginsAnewAfterAGap) {
    add(kA, 0, 0);
    add(kA, 0.001, 0);
    add(kA, 1, 500, true);
    const auto filtered = values({kCustom, {kPositionOfA}, {}, 1});
    ASSERT_EQ(filtered.size(), 3U);
    EXPECT_EQ(filtered[2].error, 500);
    EXPECT_TRUE(filtered[2].gapBefore);
}

/// i^2 counts every 2 ms are 500 000 counts/s^2.
TEST_F(CustomSignals, ADerivedSignalCanBeAPart) {
    for (int i = 0; i < 100; ++i)
        add(kA, 0.002 * i, i * i);
    const auto made = values({kCustom, {{kA, ScopeSignal::Acceleration}, {0.001, 0}}});
    ASSERT_EQ(made.size(), 80U) << "40 ms of the samples have no acceleration";
    for (const ScopeSample& value : made)
        EXPECT_NEAR(value.error, 500, 1e-3);
}

TEST_F(CustomSignals, AnotherDefinitionIsComputedFromAllSamples) {
    for (int i = 0; i < 10; ++i)
        add(kA, i, i);
    EXPECT_EQ(values({kCustom, {kPositionOfA, {2, 0}}}).back().error, 18);
    const auto again = values({kCustom, {kPositionOfA, {3, 0}}});
    ASSERT_EQ(again.size(), 10U);
    EXPECT_EQ(again.back().error, 27);
    derived.want({}, {});
    EXPECT_EQ(derived.source(history, kCustom).samples, nullptr);
}

TEST_F(CustomSignals, ReplacedDataAreComputedFromNothing) {
    add(kA, 0, 1);
    add(kA, 1, 2);
    const CustomSignal how{kCustom, {kPositionOfA}};
    EXPECT_EQ(values(how).size(), 2U);
    derived.forget();
    history = History(2);
    add(kA, 5, 7);
    const auto made = values(how);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(made[0].error, 7);
}

}  // namespace
}  // namespace nmc
