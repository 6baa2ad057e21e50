// SPDX-License-Identifier: MIT
#include "model/response/responsemetrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nmc {

namespace {

constexpr double kLastPart = 0.2;

/// Position in counts along the step: 0 at the goal, negative before it.
struct StepReading {
    double seconds = 0.0;
    double beyond = 0.0;
    bool gapBefore = false;  ///< samples are missing before this one
};

/// Marks readings that follow the previous one after several usual intervals; the usual interval is the
/// median.
void markGaps(std::vector<StepReading>& readings) {
    std::vector<double> between;
    for (std::size_t i = 2; i < readings.size(); ++i)  // the first may lie anywhere after the step
        between.push_back(readings[i].seconds - readings[i - 1].seconds);
    const auto middle = between.begin() + static_cast<std::ptrdiff_t>(between.size() / 2);
    std::nth_element(between.begin(), middle, between.end());
    for (std::size_t i = 1; i < readings.size(); ++i)
        readings[i].gapBefore = readings[i].seconds - readings[i - 1].seconds > kSeveralIntervals * *middle;
}

/// The time at which the straight line between two readings crosses `level`.
[[nodiscard]] Figure crossing(const StepReading& a, const StepReading& b, double level) {
    if (b.gapBefore)
        return tl::unexpected(Unmeasured::SamplesMissing);
    const double part = (level - a.beyond) / (b.beyond - a.beyond);
    return Measured{a.seconds + part * (b.seconds - a.seconds), (b.seconds - a.seconds) / 2};
}

[[nodiscard]] Figure firstAt(const std::vector<StepReading>& readings, double level) {
    for (std::size_t i = 1; i < readings.size(); ++i)
        if (readings[i].beyond >= level)
            return crossing(readings[i - 1], readings[i], level);
    return tl::unexpected(Unmeasured::NeverRose);
}

[[nodiscard]] Figure riseOf(const std::vector<StepReading>& readings, double step, double timeDoubt) {
    const auto low = firstAt(readings, -step * 9 / 10);
    const auto high = firstAt(readings, -step / 10);
    if (!low || !high)
        return tl::unexpected(!high ? high.error() : low.error());
    return Measured{high->value - low->value, low->doubt + high->doubt + timeDoubt};
}

/// The height of the parabola through three readings above the middle one, which is the highest.
[[nodiscard]] double aboveMiddle(const StepReading& a, const StepReading& b, const StepReading& c) {
    const double before = (b.beyond - a.beyond) / (b.seconds - a.seconds);
    const double after = (c.beyond - b.beyond) / (c.seconds - b.seconds);
    const double bend = (after - before) / (c.seconds - a.seconds);
    if (bend >= 0)
        return 0.0;
    const double slope =
        (before * (c.seconds - b.seconds) + after * (b.seconds - a.seconds)) / (c.seconds - a.seconds);
    return slope * slope / (-4 * bend);
}

[[nodiscard]] Figure overshootOf(const std::vector<StepReading>& readings, double step, double band) {
    for (std::size_t i = 1; i < readings.size(); ++i) {
        const bool onTheWay = std::abs(readings[i - 1].beyond) > band || std::abs(readings[i].beyond) > band;
        if (readings[i].gapBefore && onTheWay)
            return tl::unexpected(Unmeasured::SamplesMissing);
    }
    const auto highest = std::ranges::max_element(readings, {}, &StepReading::beyond);
    double added = 0.0;
    if (highest != readings.begin() && highest + 1 != readings.end())
        added = aboveMiddle(*(highest - 1), *highest, *(highest + 1));
    const double over = std::max(0.0, highest->beyond + added);
    return Measured{100 * over / step, 100 * (added + kHalfCount) / step};
}

/// `middle`: the centre of the band, measured from the goal.
[[nodiscard]] Figure settlingOf(const std::vector<StepReading>& readings, double middle, double band,
                                double lastPart, double timeDoubt) {
    const auto outside = [=](const StepReading& reading) { return std::abs(reading.beyond - middle) > band; };
    const auto last = std::find_if(readings.rbegin(), readings.rend(), outside);
    if (last == readings.rend())
        return Measured{0.0, timeDoubt};
    if (last->seconds >= lastPart)
        return tl::unexpected(Unmeasured::NeverSettled);
    const StepReading& inside = *(last - 1);  // iterating backwards, so this is the next reading
    Figure settled = crossing(*last, inside, last->beyond > middle ? middle + band : middle - band);
    if (settled)
        settled->doubt += timeDoubt;
    return settled;
}

[[nodiscard]] Figure steadyErrorOf(std::span<const ResponsePoint> points, double goal, double lastPart) {
    auto mean = meanOf(points, &ResponsePoint::position, lastPart, std::numeric_limits<double>::infinity(),
                       kHalfCount);
    if (mean)
        mean->value = goal - mean->value;
    return mean;
}

[[nodiscard]] Figure settlingAtRestOf(const std::vector<StepReading>& readings, double step, double band,
                                      double lastPart, double timeDoubt) {
    double sum = 0.0;
    std::size_t count = 0;
    for (auto reading = readings.rbegin(); reading != readings.rend() && reading->seconds >= lastPart;
         ++reading, ++count)
        sum += reading->beyond;
    if (count < kFewestForMean)
        return tl::unexpected(Unmeasured::TooFewSamples);
    const double rest = sum / static_cast<double>(count);
    if (rest + step <= band)
        return tl::unexpected(Unmeasured::NeverRose);
    return settlingOf(readings, rest, band, lastPart, timeDoubt);
}

}  // namespace

Figure meanOf(std::span<const ResponsePoint> points, double ResponsePoint::*value, double from, double to,
              double leastDoubt) {
    double sum = 0.0, lowest = 0.0, highest = 0.0;
    std::size_t count = 0;
    for (const ResponsePoint& point : points) {
        if (point.seconds < from || point.seconds > to)
            continue;
        lowest = count == 0 ? point.*value : std::min(lowest, point.*value);
        highest = count == 0 ? point.*value : std::max(highest, point.*value);
        sum += point.*value;
        ++count;
    }
    if (count < kFewestForMean)
        return tl::unexpected(Unmeasured::TooFewSamples);
    return Measured{sum / static_cast<double>(count), std::max(leastDoubt, (highest - lowest) / 2)};
}

ResponseMetrics measureResponse(std::span<const ResponsePoint> points, double from, double goal, double band,
                                double timeDoubt) {
    const double step = std::abs(goal - from);
    std::vector<StepReading> readings{{0.0, -step}};  // it still stands when the command is latched
    for (const ResponsePoint& point : points)
        if (point.seconds > readings.back().seconds)
            readings.push_back({point.seconds, goal < from ? goal - point.position : point.position - goal});
    if (readings.size() <= kFewestForMean) {
        const auto none = tl::unexpected(Unmeasured::TooFewSamples);
        return {none, none, none, none, none, 0.0};
    }
    markGaps(readings);
    const double length = readings.back().seconds;
    const double lastPart = length * (1 - kLastPart);
    ResponseMetrics metrics{riseOf(readings, step, timeDoubt),
                            overshootOf(readings, step, band),
                            settlingOf(readings, 0.0, band, lastPart, timeDoubt),
                            settlingAtRestOf(readings, step, band, lastPart, timeDoubt),
                            steadyErrorOf(points, goal, lastPart),
                            0.0};
    metrics.interval = (length - readings[1].seconds) / static_cast<double>(readings.size() - 2);
    return metrics;
}

}  // namespace nmc
