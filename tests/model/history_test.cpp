// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/history.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "scopesamples.h"
#include "servofixture.h"

namespace nmc {
namespace {

using testing_support::atSeconds;
using testing_support::sampleAt;

constexpr std::array kSignals{ScopeSignal::Position, ScopeSignal::Command, ScopeSignal::Error,
                              ScopeSignal::Velocity, ScopeSignal::Analog};

std::vector<ScopeSpan> spansOf(const ModuleHistory& history, double from, double to, double widest) {
    std::vector<ScopeSpan> spans;
    history.visit(atSeconds(from), atSeconds(to), fromSeconds(widest),
                  [&](const ScopeSpan& span) { spans.push_back(span); });
    return spans;
}

/// Arbitrary samples: steps of up to 50 ms, unknown errors and velocities, gaps.
std::vector<ScopeSample> anySamples() {
    const auto count = *rc::gen::inRange(1, 700);
    std::vector<ScopeSample> samples;
    std::int64_t time = 0;
    for (int i = 0; i < count; ++i) {
        ScopeSample sample;
        time += *rc::gen::inRange<std::int64_t>(1, 50'000'000);
        sample.time = TimePoint(Duration(time));
        sample.position = *rc::gen::arbitrary<std::int32_t>();
        if (*rc::gen::inRange(0, 4) > 0) {
            sample.error = static_cast<float>(*rc::gen::inRange(-30'000, 30'000)) / 8;
            sample.errorLow = sample.error - 1;
            sample.errorHigh = sample.error + 2;
        }
        if (*rc::gen::inRange(0, 4) > 0)
            sample.velocity = static_cast<float>(*rc::gen::inRange(-30'000, 30'000));
        sample.analog = *rc::gen::arbitrary<std::uint8_t>();
        sample.status = *rc::gen::arbitrary<std::uint8_t>();
        sample.gapBefore = *rc::gen::inRange(0, 20) == 0;
        samples.push_back(sample);
    }
    return samples;
}

std::size_t numberBehind(const std::vector<ScopeSample>& samples, const ScopeSpan& span) {
    std::size_t number = 0;
    while (number < samples.size() && samples[number].time <= span.last)
        ++number;
    return number;
}

void expectSums(const ScopeSpan& span, const std::vector<ScopeSample>& samples, std::size_t begin,
                std::size_t end) {
    RC_ASSERT(span.first == samples[begin].time);
    RC_ASSERT(span.last == samples[end - 1].time);
    RC_ASSERT(span.gapBefore == samples[begin].gapBefore);
    RC_ASSERT(span.errorAtFirst == samples[begin].errorKnown());
    RC_ASSERT(span.errorAtLast == samples[end - 1].errorKnown());
    for (const ScopeSignal signal : kSignals) {
        std::optional<double> low, high;
        bool lowFirst = true;
        for (std::size_t i = begin; i < end; ++i) {
            const auto value = valueOf(samples[i], signal);
            if (!value)
                continue;
            if (high && *value > *high)
                lowFirst = true;
            if (low && *value < *low)
                lowFirst = false;
            low = low ? std::min(*low, *value) : *value;
            high = high ? std::max(*high, *value) : *value;
        }
        const ScopeSpan::Extremes extremes = span.extremes(signal);
        RC_ASSERT(extremes.known() == low.has_value());
        if (!low)
            continue;
        RC_ASSERT(extremes.low == *low);
        RC_ASSERT(extremes.high == *high);
        RC_ASSERT((*low == *high || extremes.lowFirst == lowFirst));
    }
    std::uint8_t all = 0xFF, any = 0;
    for (std::size_t i = begin; i < end; ++i) {
        all &= samples[i].status;
        any |= samples[i].status;
    }
    RC_ASSERT(span.statusAll == all);
    RC_ASSERT(span.statusAny == any);
}

RC_GTEST_PROP(History, AWindowShowsAllItsSamplesAndOneBeyondEachEndInSpansThatFit, ()) {
    const std::vector<ScopeSample> samples = anySamples();
    ModuleHistory history;
    for (const ScopeSample& sample : samples)
        history.append(sample);
    const std::int64_t end = samples.back().time.time_since_epoch().count();
    const TimePoint from(Duration(*rc::gen::inRange<std::int64_t>(-1'000, end + 1)));
    const TimePoint to = from + Duration(*rc::gen::inRange<std::int64_t>(1, 20'000'000'000));
    const Duration widest(*rc::gen::inRange<std::int64_t>(0, 3'000'000'000));

    std::size_t number = 0;
    while (number + 1 < samples.size() && samples[number + 1].time <= from)
        ++number;
    history.visit(from, to, widest, [&](const ScopeSpan& span) {
        RC_ASSERT(number < samples.size());
        RC_ASSERT(span.first == samples[number].time);
        // Without the parentheses, rapidcheck evaluates both sides.
        RC_ASSERT((number == 0 || samples[number - 1].time <= to));
        RC_ASSERT(span.last - span.first <= widest);
        expectSums(span, samples, number, numberBehind(samples, span));
        number = numberBehind(samples, span);
    });
    RC_ASSERT((number == samples.size() || samples[number - 1].time > to));
}

TEST(History, APictureThatScrollsIsCutAtTheSamePlaces) {
    ModuleHistory history;
    for (int i = 0; i < 100'000; ++i)
        history.append(sampleAt(i * 0.002, i % 17));
    // 100 s in 1000 columns; after scrolling by half a column, the same columns begin at the same samples.
    const auto before = spansOf(history, 50.0, 150.0, 0.1);
    const auto after = spansOf(history, 50.05, 150.05, 0.1);
    std::set<TimePoint> places;
    for (const ScopeSpan& span : after)
        places.insert(span.first);
    std::size_t shared = 0, inside = 0;
    for (const ScopeSpan& span : before) {
        if (span.first < atSeconds(50.5) || span.last > atSeconds(149.5))
            continue;
        ++inside;
        shared += places.count(span.first);
    }
    EXPECT_GT(inside, 900U);
    EXPECT_EQ(shared, inside);
}

TEST(History, ManySamplesNeedNoMoreSpansThanFew) {
    // Each span is at least half a column wide, so there are two per column and a few more at both ends.
    for (const int count : {1'000, 100'000, 1'000'000}) {
        ModuleHistory history;
        for (int i = 0; i < count; ++i)
            history.append(sampleAt(i * 100.0 / count, i));
        EXPECT_LE(spansOf(history, 0, 100, 0.1).size(), 2'100U) << count;
    }
}

TEST(History, WherePollsAreRareEverySampleIsDrawn) {
    ModuleHistory history;
    for (int i = 0; i < 50; ++i)
        history.append(sampleAt(i, i));
    for (int i = 0; i < 10'000; ++i)
        history.append(sampleAt(50 + i * 0.002, i));
    const auto spans = spansOf(history, 0, 70, 0.1);
    EXPECT_EQ(std::count_if(spans.begin(), spans.end(),
                            [](const ScopeSpan& s) { return s.first < atSeconds(49.5); }),
              50);
}

TEST(History, NeverJoinsAcrossAGapOrAnUnknownError) {
    ModuleHistory history;
    for (int i = 0; i < 10; ++i) {
        ScopeSample sample = sampleAt(i, i);
        sample.gapBefore = i == 4;
        if (i != 7)
            sample.error = 1;
        history.append(sample);
    }
    const auto spans = spansOf(history, 0, 10, 0.1);
    ASSERT_EQ(spans.size(), 10U);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        EXPECT_EQ(spans[i].joins(spans[i - 1], ScopeSignal::Position), i != 4) << i;
        EXPECT_EQ(spans[i].joins(spans[i - 1], ScopeSignal::Error), i != 4 && i != 7 && i != 8) << i;
    }
}

TEST(History, IgnoresATimeThatGoesBack) {
    ModuleHistory history;
    history.append(sampleAt(2, 1));
    history.append(sampleAt(1, 2));
    EXPECT_EQ(history.count(), 1U);
}

TEST(History, StaysWithinItsMemoryAndKeepsOldExtremes) {
    constexpr std::size_t kSmall = 2U << 20U;
    History history(2, kSmall);
    // 2 million samples would be 64 MB; one of the oldest is high.
    std::size_t most = 0;
    for (int i = 0; i < 2'000'000; ++i) {
        history.append(ModuleIndex(i % 3 == 0 ? 1 : 0), sampleAt(i * 0.001, i == 12'346 ? 1'000 : i % 2));
        if (i % 10'000 == 0)
            most = std::max(most, history.bytes());
    }
    EXPECT_LE(most, kSmall + kSmall / 4);
    const ModuleHistory& module = *history.module(ModuleIndex(0));
    EXPECT_EQ(module.begin(), atSeconds(0.001));
    const auto spans = spansOf(module, 0, 2'000, 2.0);
    EXPECT_EQ(spans.front().first, atSeconds(0.001));
    std::int32_t highest = 0;
    for (const ScopeSpan& span : spans)
        highest = std::max(highest, span.positionHigh);
    EXPECT_EQ(highest, 1'000);
    // Nothing is missing between old and new.
    for (std::size_t i = 1; i < spans.size(); ++i)
        ASSERT_LE(toSeconds(spans[i].first - spans[i - 1].last), 0.0021) << i;
}

TEST(History, KeepsTenMinutesOfTheFastestModuleInFull) {
    // At 115 200 Bd, about 660 polls fit into a second.
    History history(1);
    for (int i = 0; i < 11 * 60 * 660; ++i)
        history.append(ModuleIndex(0), sampleAt(i / 660.0, i));
    EXPECT_LE(history.bytes(), History::kBudget);
    EXPECT_EQ(history.module(ModuleIndex(0))
                  ->countBetween(atSeconds(59.9999), atSeconds(700), ScopeSignal::Position),
              10U * 60 * 660);
}

TEST(History, KnowsTheSamplesAroundATime) {
    ModuleHistory history;
    EXPECT_FALSE(history.around(atSeconds(1)).before.has_value());
    history.append(sampleAt(1, 10));
    history.append(sampleAt(3, 30));
    EXPECT_EQ(history.around(atSeconds(2)).before->position, 10);
    EXPECT_EQ(history.around(atSeconds(2)).after->position, 30);
    EXPECT_EQ(history.around(atSeconds(3)).before->position, 30);
    EXPECT_FALSE(history.around(atSeconds(0.5)).before.has_value());
    EXPECT_FALSE(history.around(atSeconds(4)).after.has_value());
}

TEST(History, BetweenTwoSamplesAValueIsOnAStraightLineButNotAcrossAGap) {
    ModuleHistory history;
    history.append(sampleAt(1, 10));
    history.append(sampleAt(3, 30));
    ScopeSample behindGap = sampleAt(5, 50);
    behindGap.gapBefore = true;
    history.append(behindGap);
    EXPECT_EQ(history.valueAt(atSeconds(1.5), ScopeSignal::Position), 15.0);
    EXPECT_EQ(history.valueAt(atSeconds(3), ScopeSignal::Position), 30.0);
    EXPECT_EQ(history.valueAt(atSeconds(5), ScopeSignal::Position), 50.0);
    EXPECT_FALSE(history.valueAt(atSeconds(4), ScopeSignal::Position).has_value());
    EXPECT_FALSE(history.valueAt(atSeconds(0.5), ScopeSignal::Position).has_value());
    EXPECT_FALSE(history.valueAt(atSeconds(6), ScopeSignal::Position).has_value());
    EXPECT_FALSE(history.valueAt(atSeconds(1.5), ScopeSignal::Error).has_value());
}

TEST(History, ACutHoldsTheSamplesOfItsTime) {
    History history(2);
    for (int i = 0; i < 100; ++i)
        history.append(ModuleIndex(static_cast<std::uint8_t>(i % 2)), sampleAt(i, i));
    const History part = history.cut(atSeconds(10), atSeconds(20));
    EXPECT_EQ(part.begin(), atSeconds(10));
    EXPECT_EQ(part.end(), atSeconds(20));
    EXPECT_EQ(part.module(ModuleIndex(0))->count(), 6U);
    EXPECT_EQ(part.module(ModuleIndex(1))->count(), 5U);
}

TEST(History, ACutHoldsTheGainsThatWereInForce) {
    History history(2);
    const auto note = [&](int module, double seconds, std::uint16_t kp) {
        servo::SetGain gains;
        gains.kp = kp;
        history.noteGains({ModuleIndex(static_cast<std::uint8_t>(module)), atSeconds(seconds), gains});
    };
    note(0, 1, 10);
    note(1, 2, 20);
    note(0, 3, 11);
    note(0, 7, 12);
    note(1, 9, 21);
    const History part = history.cut(atSeconds(5), atSeconds(8));
    std::vector<std::uint16_t> kept;
    for (const GainsChange& change : part.gains())
        kept.push_back(change.gains->kp);
    EXPECT_EQ(kept, (std::vector<std::uint16_t>{20, 11, 12}));
}

TEST(History, TellsWhatHasComeSince) {
    History history(1);
    for (int i = 0; i < 5; ++i)
        history.append(ModuleIndex(0), sampleAt(1, i));
    std::vector<std::int32_t> since;
    history.module(ModuleIndex(0))->visitSince(3, [&](const ScopeSample& sample) {
        since.push_back(sample.position);
    });
    EXPECT_EQ(since, (std::vector<std::int32_t>{3, 4})) << "though all have the same time";
}

}  // namespace
}  // namespace nmc
