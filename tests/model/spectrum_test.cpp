// SPDX-License-Identifier: GPL-3.0-or-later
// The spectrum of a stretch of samples, compared with closed forms, and with the simulator's own positions in
// every tick.
#include "model/scope/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "model/scope/scopefeed.h"
#include "truthrig.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr double kFullTurn = 2 * std::numbers::pi;
/// Samples as polls make them: about `perSecond` a second, unevenly, one in 20 missing.
template <typename Value>
std::vector<SignalPoint> samplesOf(double seconds, double perSecond, Value value) {
    std::mt19937 random(1);
    std::vector<SignalPoint> points;
    bool joined = false;
    for (int i = 0; i <= std::lround(seconds * perSecond); ++i) {
        const double at = (i + std::uniform_real_distribution(-0.1, 0.1)(random)) / perSecond;
        const bool missing = std::uniform_int_distribution(0, 19)(random) == 0;
        if (!missing)
            points.push_back({at, value(at), joined});
        joined = !missing;
    }
    return points;
}

auto wave(double amplitude, double hertz, double offset = 0) {
    return [=](double t) { return offset + amplitude * std::sin(kFullTurn * hertz * t + 1); };
}

TEST(Spectrum, FindsASineThatIsSampledUnevenly) {
    for (const double hertz : {1.5, 7.3, 40.0, 61.7}) {
        SCOPED_TRACE(hertz);
        const auto spectrum = spectrumOf(samplesOf(4, 150, wave(30, hertz, 5'000)));
        ASSERT_TRUE(spectrum && spectrum->peak);
        EXPECT_NEAR(spectrum->peak->hertz, hertz, 0.01);
        EXPECT_NEAR(spectrum->peak->amplitude, 30, 0.03);
    }
}

/// The points around the line have its amplitude. Those far from it have little: a Hann window's side lobes
/// are below 1 in 37, and 30 of 600 samples, missing at random, make noise with a standard deviation of up to
/// 2/600 sqrt(30 * 1.5) = 1 in 45, the highest of 600 points of which reaches sqrt(2 ln 600) = 3.6 times
/// that.
TEST(Spectrum, HasALineOnlyWhereTheSineIs) {
    const auto spectrum = spectrumOf(samplesOf(4, 150, wave(30, 20)));
    ASSERT_TRUE(spectrum.has_value());
    double highest = 0, elsewhere = 0;
    for (const auto& [hertz, amplitude] : spectrum->points) {
        highest = std::max(highest, amplitude);
        if (std::abs(hertz - 20) > 5.0 / 4)
            elsewhere = std::max(elsewhere, amplitude);
    }
    EXPECT_NEAR(highest, 30, 0.3);
    EXPECT_LT(elsewhere, 30 * 3.6 / 45);
}

TEST(Spectrum, TellsTwoSinesApartAndNamesTheHigher) {
    const auto spectrum = spectrumOf(
        samplesOf(4, 150, [](double t) { return wave(10, 12)(t) + wave(4, 13.5)(t) + wave(6, 50)(t); }));
    ASSERT_TRUE(spectrum && spectrum->peak);
    EXPECT_NEAR(spectrum->peak->hertz, 12, 0.05);
    const auto at = [&](double hertz) {
        const auto first = spectrum->points.front().hertz;
        const double step = spectrum->points[1].hertz - first;
        return spectrum->points[static_cast<std::size_t>(std::lround((hertz - first) / step))].amplitude;
    };
    EXPECT_NEAR(at(13.5), 4, 0.3);
    EXPECT_LT(at(12.75), 2);
    EXPECT_NEAR(at(50), 6, 0.3);
}

/// The derivative of a sin(w t) is a w cos(w t).
TEST(Spectrum, OfARateOfChange) {
    const auto spectrum = spectrumOf(samplesOf(4, 150, wave(2, 15)), 1);
    ASSERT_TRUE(spectrum && spectrum->peak);
    EXPECT_NEAR(spectrum->peak->hertz, 15, 0.01);
    EXPECT_NEAR(spectrum->peak->amplitude, 2 * kFullTurn * 15, 0.5);
}

/// Two periods in 4 s are 0.5 Hz.
TEST(Spectrum, ReachesToNearlyHalfTheRateOfTheSamples) {
    const auto spectrum = spectrumOf(samplesOf(4, 150, wave(2, 15)));
    ASSERT_TRUE(spectrum.has_value());
    EXPECT_NEAR(spectrum->points.front().hertz, 0.5, 0.01);
    EXPECT_NEAR(spectrum->points.back().hertz, 75 - 0.5, 0.5);
}

TEST(Spectrum, FindsASineUnderADrift) {
    const auto spectrum = spectrumOf(samplesOf(4, 150, [](double t) { return 3'000 * t + wave(5, 22)(t); }));
    ASSERT_TRUE(spectrum && spectrum->peak);
    EXPECT_NEAR(spectrum->peak->hertz, 22, 0.01);
    EXPECT_NEAR(spectrum->peak->amplitude, 5, 0.01);
}

TEST(Spectrum, FindsNoPeakInWhatDoesNotOscillate) {
    for (const double slope : {0.0, 1'000.0}) {
        const auto spectrum = spectrumOf(samplesOf(4, 150, [&](double t) { return 100'000 + slope * t; }));
        ASSERT_TRUE(spectrum.has_value());
        EXPECT_FALSE(spectrum->peak.has_value()) << spectrum->peak->hertz << ' ' << spectrum->peak->amplitude;
    }
}

/// By chance in 1 of 100; 400 spectra have more than 12 false alarms with a probability of 1 in 1000.
TEST(Spectrum, FindsNoPeakInNoise) {
    std::mt19937 random(7);
    int alarms = 0;
    for (int i = 0; i < 400; ++i)
        alarms +=
            spectrumOf(samplesOf(2, 150, [&](double) { return std::normal_distribution(0.0, 3.0)(random); }))
                    ->peak
                ? 1
                : 0;
    EXPECT_LE(alarms, 12);
}

TEST(Spectrum, NeedsSamples) {
    EXPECT_FALSE(spectrumOf({}).has_value());
    EXPECT_FALSE(spectrumOf(samplesOf(0.05, 150, wave(1, 20))).has_value());
    EXPECT_FALSE(spectrumOf(std::vector<SignalPoint>(100, {1, 2, true})).has_value());
    EXPECT_FALSE(spectrumOf(samplesOf(200, 150, wave(1, 20))).has_value());
}

/// 200 samples at 2 ms, a gap, and 200 more. An hour would be 3600.8 / 0.002 = 1.8 million intervals, and its
/// transform would need 2^25 points; a second is 1.796 / 0.002 = 898 intervals.
TEST(Spectrum, OfSamplesOnBothSidesOfALongGapIsRefused) {
    const auto around = [](double gap) {
        std::vector<SignalPoint> points;
        for (int i = 0; i < 400; ++i) {
            const double at = i * 0.002 + (i < 200 ? 0 : gap);
            points.push_back({at, wave(30, 20)(at), i != 0 && i != 200});
        }
        return points;
    };
    EXPECT_TRUE(hasLongGap(around(3'600)));
    EXPECT_FALSE(spectrumOf(around(3'600)).has_value());
    EXPECT_FALSE(hasLongGap(around(1)));
    EXPECT_TRUE(spectrumOf(around(1)).has_value());
    EXPECT_FALSE(hasLongGap({}));
}

/// A servo that follows a sine of its command: the scope's samples at either baud rate, against the shaft
/// itself, tick by tick, whose amplitude over whole periods is 2/n times its Fourier sum.
TEST(Spectrum, AgreesWithTheShaftAtBothBaudRates) {
    constexpr double kHertz = 6.4, kSeconds = 5, kStretch = 3.75;  // 24 periods
    for (const std::uint32_t baud : {19'200U, 115'200U}) {
        SCOPED_TRACE(baud);
        TruthRig rig(1, bus::EngineConfig{baud});
        ASSERT_TRUE(rig.enable());
        servo::StopMotor centre = stopWith(servo::StopManner::Here);
        centre.here = Counts(0);
        static_cast<void>(rig.bus.submit({{ModuleIndex(0), ServoCommand(centre)}},
                                         bus::Sine{300, kHertz, fromSeconds(kSeconds)}));
        rig.bus.runFor(fromSeconds(1));
        const TimePoint from = rig.bus.now;
        std::complex<double> sum;
        int ticks = 0;
        for (; rig.bus.now < from + fromSeconds(kStretch); ++ticks) {
            rig.bus.runFor(kServoTick);
            sum +=
                std::polar(rig.bus.servo(0).shaftCounts, -kFullTurn * kHertz * toSeconds(rig.bus.now - from));
        }
        const double amplitude = 2 * std::abs(sum) / ticks;
        ASSERT_GT(amplitude, 100);

        ScopeFeed feed;
        std::vector<SignalPoint> points;
        for (const auto& sample : rig.bus.all<bus::Sample>())
            if (const auto taken = feed.take(sample); taken && taken->time >= from)
                points.push_back({toSeconds(taken->time - from), 1.0 * taken->position, !taken->gapBefore});
        const auto spectrum = spectrumOf(points);
        ASSERT_TRUE(spectrum && spectrum->peak);
        EXPECT_NEAR(spectrum->peak->hertz, kHertz, 0.2);
        EXPECT_NEAR(spectrum->peak->amplitude, amplitude, 0.05 * amplitude);
        // The commands' own rate is the highest line of the velocity.
        const auto velocity = spectrumOf(points, 1);
        ASSERT_TRUE(velocity.has_value());
        double highest = 0;
        for (const SpectrumPoint& point : velocity->points)
            if (std::abs(point.hertz - kHertz) < 0.2)
                highest = std::max(highest, point.amplitude);
        EXPECT_NEAR(highest, amplitude * kFullTurn * kHertz, 0.05 * amplitude * kFullTurn * kHertz);
    }
}

}  // namespace
}  // namespace nmc
