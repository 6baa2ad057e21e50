// SPDX-License-Identifier: GPL-3.0-or-later
// Frequency responses and their figures, compared with closed forms.
#include "model/frequency/frequencyresponse.h"
#include "model/frequency/othergains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/time.h"
#include "model/response/edgefold.h"
#include "model/response/frequencyfile.h"
#include "tests/support/servotick.h"

namespace nmc {
namespace {

using Complex = std::complex<double>;
using testing_support::kTick;

/// The closed loop of L(s) at twelve frequencies per decade, from 0.01 Hz on.
template <typename Loop>
[[nodiscard]] std::vector<FrequencyPoint> responseOf(Loop loop, double to) {
    std::vector<FrequencyPoint> points;
    for (double hertz = 0.01; hertz <= to; hertz *= std::pow(10, 1.0 / 12)) {
        const Complex open = loop(Complex(0, 2 * std::numbers::pi * hertz));
        points.push_back({hertz, open / (1.0 + open), 0.0});
    }
    return points;
}

/// L = w0 / s: T is of first order, with its corner at w0 and 90 degrees of margin there.
TEST(FrequencyFigures, OfAnIntegratorAreItsCorner) {
    const double corner = 5.0;
    const auto points = responseOf([&](Complex s) { return 2 * std::numbers::pi * corner / s; }, 100.0);
    const FrequencyFigures figures = figuresOf(points);
    ASSERT_TRUE(figures.bandwidth && figures.crossover && figures.phaseMargin);
    EXPECT_NEAR(*figures.bandwidth, corner, 0.02 * corner);
    EXPECT_NEAR(*figures.crossover, corner, 0.02 * corner);
    EXPECT_NEAR(*figures.phaseMargin, 90.0, 0.1);
    EXPECT_FALSE(figures.gainMargin) << "its phase never reaches -180 degrees";
    EXPECT_NEAR(figures.resonance, 0.0, 0.01);
}

/// L = k / (s (s + 1)^2) is critical at k = 2, where w = 1: with k = 0.5, it could be four times higher.
TEST(FrequencyFigures, TellTheGainMargin) {
    const auto points = responseOf([](Complex s) { return 0.5 / (s * (s + 1.0) * (s + 1.0)); }, 2.0);
    const FrequencyFigures figures = figuresOf(points);
    ASSERT_TRUE(figures.gainMargin && figures.phaseMargin);
    EXPECT_NEAR(*figures.gainMargin, 4.0, 0.1);
    // |L| = 1 where w (1 + w^2) = 0.5: w = 0.4239; 90 - 2 atan w.
    EXPECT_NEAR(*figures.phaseMargin, 90 - 2 * std::atan(0.4239) * 180 / std::numbers::pi, 1.0);
}

/// L = k (s^2 + s + 2) / (s^2 (s + 1)), a motor with an integral, lags by more than half a turn up to w = 1,
/// where L = -k. By Routh, 1 + L has its zeros on the left for k > 1.
TEST(FrequencyFigures, AreThoseOfALoopThatBeginsBeyondHalfATurn) {
    const auto loop = [](double k) {
        return [k](Complex s) { return k * (s * s + s + 2.0) / (s * s * (s + 1.0)); };
    };
    const auto points = responseOf(loop(10.0), 10.0);
    const FrequencyFigures figures = figuresOf(points);
    ASSERT_TRUE(figures.phaseMargin);
    // |L| = 1 where x = w^2 solves x^3 - 99 x^2 + 300 x - 400 = 0: w = 9.794. There the zeros lead by 180 -
    // atan(w / (x - 2)) and the pole lags by atan w, and so the margin is 180 - 5.95 - 84.17.
    EXPECT_NEAR(*figures.phaseMargin, 89.9, 1.0);
    EXPECT_FALSE(figures.gainMargin);
    EXPECT_FALSE(isUnstable(figures));
    EXPECT_TRUE(isUnstable(figuresOf(responseOf(loop(0.5), 10.0))));
    // At 0.01 Hz, w = 0.0628: the zeros lead by w / 2 and the pole lags by w: 1.8 degrees of lag remain.
    EXPECT_NEAR(phases(std::vector{points.front().open()}).front(), -181.8, 0.1);
}

/// L = k (s + 1)^2 / (s (10 s + 1)^2) has a phase of -180 degrees where 9 w / (1 + 10 w^2) = 1: at w = 0.1298
/// it falls and |L| is 2.916 k; at w = 0.7702 it comes back and |L| is 0.03429 k. With k between 1 / 2.916
/// and 1 / 0.03429, the loop is unstable.
TEST(FrequencyFigures, LeaveOutAPhaseThatComesBackWhileLIsAbove1) {
    const auto figuresWith = [](double k) {
        return figuresOf(responseOf(
            [k](Complex s) { return k * (s + 1.0) * (s + 1.0) / (s * (10.0 * s + 1.0) * (10.0 * s + 1.0)); },
            10.0));
    };
    const FrequencyFigures low = figuresWith(0.1);
    ASSERT_TRUE(low.gainMargin);
    EXPECT_NEAR(*low.gainMargin, 1 / 0.2916, 0.07);
    EXPECT_FALSE(isUnstable(low));
    const FrequencyFigures between = figuresWith(10.0);
    ASSERT_TRUE(between.gainMargin);
    EXPECT_NEAR(*between.gainMargin, 1 / 29.16, 0.001);
    EXPECT_TRUE(isUnstable(between));
    const FrequencyFigures high = figuresWith(100.0);
    ASSERT_TRUE(high.phaseMargin);
    EXPECT_FALSE(high.gainMargin);
    EXPECT_FALSE(isUnstable(high));
    // |L| = 1 where 100 (1 + w^2) = w (1 + 100 w^2): w = 1.4615; 90 + 2 (atan w - atan 10 w).
    EXPECT_NEAR(*high.phaseMargin, 29.1, 1.0);
}

constexpr servo::SetGain kGains{100, 0, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};

[[nodiscard]] std::vector<FrequencyPoint> withDoubt(std::vector<FrequencyPoint> points, double doubt) {
    for (FrequencyPoint& point : points)
        point.doubt = doubt;
    return points;
}

/// L = w0 / s with Kp alone: w0 is proportional to Kp, and so is the corner of T.
TEST(LoopWithOtherGains, HasTwiceTheCornerWithTwiceTheGain) {
    const auto loop = [](double corner) {
        return [corner](Complex s) { return 2 * std::numbers::pi * corner / s; };
    };
    servo::SetGain twice = kGains;
    twice.kp = 200;
    const auto told = withOtherGains(withDoubt(responseOf(loop(5.0), 100.0), 0.01), kGains, twice);
    const auto truth = responseOf(loop(10.0), 100.0);
    ASSERT_EQ(told.size(), truth.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        EXPECT_NEAR(std::abs(told[i].closed - truth[i].closed), 0.0, 1e-12);
        // T = 1 / (1 + jx), T' = 2 / (2 + jx): |dT'/dT| = 2 |1 + jx|^2 / |2 + jx|^2, x the frequency over 5
        // Hz.
        const double x = told[i].hertz / 5;
        EXPECT_NEAR(told[i].doubt, 0.01 * 2 * (1 + x * x) / (4 + x * x), 1e-9);
    }
    EXPECT_FALSE(isUnstable(figuresOf(told)));
}

/// The derivative is a difference over one servo tick, and the integral a sum: at a quarter of the servo rate
/// 1/z is -j, so C is Kp + Kd (1 + j) + Ki/256 / (1 + j).
TEST(LoopWithOtherGains, IsThatOfTheSampledFilter) {
    servo::SetGain all = kGains;
    all.kd = 30;
    all.ki = 512;
    all.il = 1'000;
    for (const std::uint8_t sr : {std::uint8_t{1}, std::uint8_t{4}}) {
        all.sr = sr;
        const Complex filter = filterAt(all, 0.25 / (sr * kTick));
        EXPECT_NEAR(filter.real(), 100 + 30 + 1, 1e-9);
        EXPECT_NEAR(filter.imag(), 30 - 1, 1e-9);
    }
    all.il = 0;
    EXPECT_NEAR(filterAt(all, 0.25 / (4 * kTick)).imag(), 30, 1e-9) << "without IL there is no integral";
}

/// k / (s (s + 1)^2) is critical at k = 2.
TEST(LoopWithOtherGains, ThatItWouldOscillateIsTold) {
    const auto points = responseOf([](Complex s) { return 0.5 / (s * (s + 1.0) * (s + 1.0)); }, 2.0);
    servo::SetGain higher = kGains;
    higher.kp = 380;
    EXPECT_FALSE(isUnstable(figuresOf(withOtherGains(points, kGains, higher))));
    higher.kp = 420;
    EXPECT_TRUE(isUnstable(figuresOf(withOtherGains(points, kGains, higher))));
}

TEST(LoopWithOtherGains, IsNotToldWhereSomethingElseDiffersOrALimitWasMet) {
    servo::SetGain other = kGains;
    other.el = 100;
    EXPECT_EQ(changeOf(kGains, other), LoopChange::None);
    other.kd = 1;
    EXPECT_EQ(changeOf(kGains, other), LoopChange::Filter);
    other.db = std::uint8_t{3};
    EXPECT_EQ(changeOf(kGains, other), LoopChange::Deadband);
    other.sr = 2;
    EXPECT_EQ(changeOf(kGains, other), LoopChange::Rate);
    std::vector<FrequencyPoint> points;
    for (const bool limited : {true, false, false, true, false})
        points.push_back({1.0 + static_cast<double>(points.size()), 0.5, 0.0, 0.0, limited});
    const auto told = withOtherGains(points, kGains, kGains);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told.front().hertz, 2.0);
}

TEST(FrequencyFigures, SayNothingOfWhatWasNotMeasured) {
    const auto points = responseOf([](Complex s) { return 2 * std::numbers::pi * 50.0 / s; }, 10.0);
    const FrequencyFigures figures = figuresOf(points);
    EXPECT_FALSE(figures.bandwidth);
    EXPECT_FALSE(figures.crossover);
    EXPECT_FALSE(figures.phaseMargin);
}

TEST(FrequencyFigures, TellWhatTwoStandardDeviationsLeaveOpen) {
    const FrequencySpread spread = spreadOf({1.0, {0.0, -0.5}, 0.05});  // |T| from 0.4 to 0.6
    EXPECT_NEAR(spread.lowest, -7.959, 0.001);
    EXPECT_NEAR(spread.highest, -4.437, 0.001);
    EXPECT_NEAR(spread.degrees, 11.537, 0.001) << "the tangents to a circle of 0.1 about 0.5";
    const FrequencySpread nothing = spreadOf({1.0, 0.05, 0.05});
    EXPECT_EQ(nothing.lowest, kFaintest);
    EXPECT_EQ(nothing.degrees, 180.0);
}

/// With all gains 0, the loop does not respond at all.
TEST(FrequencyFigures, AreFiniteWithoutAnyResponse) {
    EXPECT_EQ(decibels(0.0), kFaintest);
    EXPECT_EQ(decibels(1e-7), kFaintest);  // -140 dB
    const FrequencySpread spread = spreadOf({1.0, 0.0, 0.0});
    EXPECT_EQ(spread.lowest, kFaintest);
    EXPECT_EQ(spread.highest, kFaintest);
    servo::SetGain zero = kGains;
    zero.kp = 0;
    const auto told = withOtherGains(std::vector<FrequencyPoint>{{1.0, {0.5, 0.0}, 0.01}}, kGains, zero);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(decibels(told[0].closed), kFaintest);
    EXPECT_EQ(decibels(told[0].open()), kFaintest);
}

TEST(FrequencyFigures, PhasesGoOnBeyondHalfATurn) {
    std::vector<Complex> turning;
    for (int i = 0; i < 8; ++i)
        turning.push_back(std::polar(1.0, -i * std::numbers::pi / 3));
    const std::vector<double> turned = phases(turning);
    for (std::size_t i = 0; i < turned.size(); ++i)
        EXPECT_NEAR(turned[i], -60.0 * static_cast<double>(i), 1e-9);
}

/// A command every 6 ms at an exactly known time, and positions of a known motor: one with each command, two
/// in between.
class MeasuredSine : public testing::Test {
protected:
    void swing(double hertz, Complex answer, double seconds) {
        const double omega = 2 * std::numbers::pi * hertz;
        for (double t = 0; t < seconds; t += 0.006) {
            record.commands.push_back({at(t), rounded(1'000 * std::sin(omega * t))});
            for (const double later : {0.0, 0.002, 0.004}) {
                // The fundamental of the staircase is later by half a step and a tick, and a little smaller.
                const double half = omega * 0.003;
                const double size = 1'000 * std::sin(half) / half * std::abs(answer);
                const double phase = omega * (t + later - kTick) - half + std::arg(answer);
                auto& points = later == 0.0 ? record.answers : record.polls;
                points.push_back({at(t + later), rounded(size * std::sin(phase) + 500 + 20 * (t + later))});
            }
        }
    }
    [[nodiscard]] static TimePoint at(double seconds) { return TimePoint{} + fromSeconds(seconds); }
    [[nodiscard]] static std::int32_t rounded(double counts) {
        return static_cast<std::int32_t>(std::lround(counts));
    }
    bus::SineRecord record;
};

TEST_F(MeasuredSine, FindsMagnitudeAndPhase) {
    for (const double hertz : {1.0, 4.0, 15.0}) {
        record = {};
        const Complex answer = std::polar(0.7, -0.9);
        swing(hertz, answer, std::max(1.0, 5 / hertz));
        const auto point = measureFrequency(record, hertz);
        ASSERT_TRUE(point);
        EXPECT_NEAR(decibels(point->closed / answer), 0.0, 0.3) << hertz;
        EXPECT_NEAR(std::arg(point->closed / answer) * 180 / std::numbers::pi, 0.0, 2.0) << hertz;
        EXPECT_LT(point->doubt, 0.05);
    }
}

/// At 1 Hz, the command jumps by at most 2 pi 1000 * 6 ms = 38 counts, so Kd 1000 asks for 147 PWM counts.
/// The position is 0.7 times as large and 0.9 rad late: |1 - T| is 0.79, so Kp 10 asks for 31 in 1/256.
TEST_F(MeasuredSine, OutputLimitsAreNoticed) {
    swing(1.0, std::polar(0.7, -0.9), 5.0);
    const FrequencyPoint point{1.0, std::polar(0.7, -0.9), 0.0};
    servo::SetGain gains{10, 1'000, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};
    EXPECT_FALSE(meetsLimits(record, point, gains, 1'000));
    gains.ol = 100;
    EXPECT_TRUE(meetsLimits(record, point, gains, 1'000));
    gains.ol = 255;
    gains.ki = 10;
    gains.il = 1'000;  // 39 PWM counts: friction may have kept the integral there
    EXPECT_TRUE(meetsLimits(record, point, gains, 1'000));
    gains.il = 32'000;  // 1250, of which the sine moves 0.04 / 0.0032 * 790 / 256 = 37
    EXPECT_FALSE(meetsLimits(record, point, gains, 1'000));
    record.answers.pop_back();
    EXPECT_TRUE(meetsLimits(record, point, gains, 1'000)) << "not known";
}

TEST_F(MeasuredSine, IsNothingWithoutPositions) {
    EXPECT_FALSE(measureFrequency(record, 1.0));
    swing(1.0, 1.0, 5.0);
    record.polls.clear();
    record.answers.clear();
    EXPECT_FALSE(measureFrequency(record, 1.0));
}

TEST(FrequencyFile, HasARowForEachFrequency) {
    const std::vector<FrequencyPoint> points{{1.0, {0.5, 0.0}, 0.25}, {2.0, {0.0, -0.5}, 0.25}};
    const RecordingHeader origin{
        "NMC Panel 0.6.0", "2026-11-21T21:21:02.123+01:00", {}, "simulator", true, {}};
    const GainsChange gains{ModuleIndex(2), TimePoint(std::chrono::seconds(5)), kGains};
    const std::string text = frequencyCsv(origin, "Module 3", points, gains);
    EXPECT_TRUE(text.starts_with(
        "# NMC Panel frequency response 1\n"
        "# program: NMC Panel 0.6.0\n"
        "# started: 2026-11-21T21:21:02.123+01:00\n"
        "# port: simulator\n"
        "# simulated: yes (no real motor moved)\n"
        "# module: Module 3\n"
        "# gains of module 3 at 0.000000000 s: kp 100 kd 0 ki 0 il 0 ol 255 cl 0 el 4000 sr 1 db 0\n"
        "frequency_hz,closed_db,closed_deg,closed_doubt,open_db,open_deg\n"))
        << text;
    // T = 1/2: L = 1, 0 dB.
    EXPECT_NE(text.find("\n1,-6.02"), std::string::npos);
    EXPECT_NE(text.find(",0,0.25,0,0\n"), std::string::npos);
    EXPECT_NE(text.find(",-90,0.25,"), std::string::npos);
    EXPECT_NE(frequencyCsv(origin, "Module 3", points, gains, 5'000)
                  .find(" db 0\n# speed while measuring: 5000 counts/s\nfrequency_hz,"),
              std::string::npos);
}

[[nodiscard]] ResponseRecord edge(std::int32_t from, std::int32_t goal, double late, std::uint16_t kp = 100) {
    ResponseRecord run;
    run.taken.from = from;
    run.taken.goal = goal;
    run.taken.record = 0.2;
    run.taken.gains.kp = kp;
    run.bandPercent = kFirstBand;
    for (double t = late; t < 0.2; t += 0.002)
        run.points.push_back({t, from + (goal - from) * (1 - std::exp(-t / 0.02))});
    return run;
}

TEST(EdgeFold, LaysEdgesWithTheSameGainsOverOneAnother) {
    std::vector<ResponseRecord> edges;
    for (int i = 0; i < 4; ++i) {
        edges.push_back(edge(-50, 50, i * 0.0005));
        edges.push_back(edge(50, -50, i * 0.0005));
    }
    const auto forward = foldEdges(edges, true);
    ASSERT_TRUE(forward);
    const std::vector<FoldedPoint>& folded = forward->points;
    unsigned samples = 0;
    for (const FoldedPoint& point : folded) {
        samples += point.samples;
        EXPECT_NEAR(point.position, 100 * (1 - std::exp(-point.seconds / 0.02)), 2.0);
        EXPECT_LE(point.low, point.high);
    }
    EXPECT_EQ(samples, 4 * 100U);
    EXPECT_GE(folded.size(), 120U) << "one edge has 100 samples";
    EXPECT_EQ(forward->run.taken.from, -50);
    ASSERT_TRUE(forward->run.metrics.rise);
    // The rise takes ln 9 time constants.
    EXPECT_NEAR(forward->run.metrics.rise->value, 0.02 * std::log(9.0), 0.001);
    const auto back = foldEdges(edges, false);
    ASSERT_TRUE(back);
    for (const FoldedPoint& point : back->points)
        EXPECT_LE(point.position, 0.0);
}

TEST(EdgeFold, LeavesOutEdgesWithOtherGains) {
    const std::vector<ResponseRecord> edges{edge(-50, 50, 0, 100), edge(-50, 50, 0, 300)};
    const auto forward = foldEdges(edges, true);
    ASSERT_TRUE(forward);
    unsigned samples = 0;
    for (const FoldedPoint& point : forward->points)
        samples += point.samples;
    EXPECT_EQ(samples, 100U);
    EXPECT_EQ(forward->run.taken.gains.kp, 300);
    EXPECT_FALSE(foldEdges(edges, false));
    EXPECT_FALSE(foldEdges({}, true));
}

}  // namespace
}  // namespace nmc
