// SPDX-License-Identifier: MIT
#include "model/stepmetrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace nmc {

namespace {

constexpr double kLastPart = 0.2;
constexpr std::size_t kFewest = 3;

/// As a share of the step: 0 where it began, 1 at its goal.
struct Share {
    double seconds = 0.0;
    double way = 0.0;
};

/// Where the straight line between two points is at `level`.
[[nodiscard]] Measured crossing(const Share& a, const Share& b, double level) {
    const double part = (level - a.way) / (b.way - a.way);
    return {a.seconds + part * (b.seconds - a.seconds), (b.seconds - a.seconds) / 2};
}

[[nodiscard]] std::optional<Measured> firstAbove(const std::vector<Share>& shares, double level) {
    for (std::size_t i = 1; i < shares.size(); ++i)
        if (shares[i].way >= level)
            return crossing(shares[i - 1], shares[i], level);
    return std::nullopt;
}

[[nodiscard]] StepMetrics::Result<Measured> riseOf(const std::vector<Share>& shares, double timeDoubt) {
    const auto low = firstAbove(shares, 0.1);
    const auto high = firstAbove(shares, 0.9);
    if (!low || !high)
        return tl::unexpected(Unmeasured::NeverRose);
    return Measured{high->value - low->value, low->doubt + high->doubt + timeDoubt};
}

/// How far the parabola through three points is above the middle one, which is the highest.
[[nodiscard]] double aboveMiddle(const Share& a, const Share& b, const Share& c) {
    const double before = (b.way - a.way) / (b.seconds - a.seconds);
    const double after = (c.way - b.way) / (c.seconds - b.seconds);
    const double bend = (after - before) / (c.seconds - a.seconds);
    if (bend >= 0)
        return 0.0;
    const double slope =
        (before * (c.seconds - b.seconds) + after * (b.seconds - a.seconds)) / (c.seconds - a.seconds);
    return slope * slope / (-4 * bend);
}

[[nodiscard]] Measured overshootOf(const std::vector<Share>& shares, double count) {
    const auto highest = std::max_element(shares.begin(), shares.end(),
                                          [](const Share& a, const Share& b) { return a.way < b.way; });
    double added = 0.0;
    if (highest != shares.begin() && highest + 1 != shares.end())
        added = aboveMiddle(*(highest - 1), *highest, *(highest + 1));
    const double over = std::max(0.0, highest->way + added - 1);
    return {100 * over, 100 * (added + count / 2)};
}

[[nodiscard]] StepMetrics::Result<Measured> settlingOf(const std::vector<Share>& shares, double band,
                                                       double lastPart, double timeDoubt) {
    const auto outside = [band](const Share& s) { return std::abs(s.way - 1) > band; };
    const auto last = std::find_if(shares.rbegin(), shares.rend(), outside);
    if (last == shares.rend())
        return Measured{0.0, timeDoubt};
    if (last->seconds >= lastPart)
        return tl::unexpected(Unmeasured::NeverSettled);
    const double edge = last->way > 1 ? 1 + band : 1 - band;
    Measured settled = crossing(*last, *(last - 1), edge);  // backwards, so the one after
    settled.doubt += timeDoubt;
    return settled;
}

[[nodiscard]] StepMetrics::Result<Measured> steadyErrorOf(std::span<const StepPoint> points, double goal,
                                                          double lastPart) {
    double sum = 0.0, lowest = 0.0, highest = 0.0;
    std::size_t count = 0;
    for (const StepPoint& point : points) {
        if (point.seconds < lastPart)
            continue;
        lowest = count == 0 ? point.position : std::min(lowest, point.position);
        highest = count == 0 ? point.position : std::max(highest, point.position);
        sum += point.position;
        ++count;
    }
    if (count < kFewest)
        return tl::unexpected(Unmeasured::TooFewSamples);
    return Measured{goal - sum / static_cast<double>(count), std::max(0.5, (highest - lowest) / 2)};
}

}  // namespace

StepMetrics measureStep(std::span<const StepPoint> points, double from, double goal, double band,
                        double timeDoubt) {
    const double step = goal - from;
    std::vector<Share> shares{{}};  // when the command is latched it still stands
    for (const StepPoint& point : points)
        if (point.seconds > shares.back().seconds)
            shares.push_back({point.seconds, (point.position - from) / step});
    if (shares.size() <= kFewest) {
        const auto none = tl::unexpected(Unmeasured::TooFewSamples);
        return {none, none, none, none, 0.0};
    }
    const double length = shares.back().seconds;
    const double lastPart = length * (1 - kLastPart);
    StepMetrics metrics{riseOf(shares, timeDoubt), overshootOf(shares, 1 / std::abs(step)),
                        settlingOf(shares, band / std::abs(step), lastPart, timeDoubt),
                        steadyErrorOf(points, goal, lastPart), 0.0};
    metrics.interval = (length - shares[1].seconds) / static_cast<double>(shares.size() - 2);
    return metrics;
}

}  // namespace nmc
