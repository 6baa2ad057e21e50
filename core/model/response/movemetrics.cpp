// SPDX-License-Identifier: MIT
#include "model/response/movemetrics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/intent/moveforecast.h"

namespace nmc {

namespace {

[[nodiscard]] Figure settlingOf(std::span<const ResponsePoint> points, double goal, double end, double usual,
                                const SettleWindow& window, double timeDoubt) {
    // Positions are whole counts: the edge is half-way between the last one inside and the first one outside.
    const double edge = std::floor(window.counts) + kHalfCount;
    std::optional<double> since;
    double doubt = timeDoubt;
    const ResponsePoint* before = nullptr;
    for (const ResponsePoint& point : points) {
        const double off = std::abs(goal - point.position);
        const bool gap = before != nullptr && point.seconds - before->seconds > kSeveralIntervals * usual;
        if (point.seconds > end && gap && (since || off <= edge))
            return tl::unexpected(Unmeasured::SamplesMissing);
        if (off > edge) {
            since.reset();
        } else if (!since) {
            const double was = before != nullptr ? std::abs(goal - before->position) : off;
            const double interval = before != nullptr ? point.seconds - before->seconds : 0.0;
            const double part = was > edge ? (was - edge) / (was - off) : 1.0;
            since = point.seconds - (1 - part) * interval;
            doubt = timeDoubt + interval / 2;
        }
        if (since && point.seconds - std::max(*since, end) >= window.dwell)
            return *since <= end ? Measured{0.0, timeDoubt} : Measured{*since - end, doubt};
        before = &point;
    }
    return tl::unexpected(Unmeasured::NeverSettled);
}

/// At servo rate SR, the chip moves the command in one of SR ticks, and which one is not known.
[[nodiscard]] double errorDoubt(double velocity, int servoRate) {
    const int divisor = std::max(servoRate, 1);
    return kHalfCount + velocity * (divisor - 1) / (2.0 * divisor);
}

/// It may have been larger between two samples, by what it changed from one to the next. `doubt`: between the
/// two ends of the time in which the chip moves the command.
[[nodiscard]] Figure peakOf(std::span<const ResponsePoint> points, double doubt) {
    const auto size = [](const ResponsePoint& point) { return std::abs(point.error); };
    const auto largest = std::ranges::max_element(points, {}, size);
    double change = 0.0;
    if (largest != points.begin())
        change = size(*largest) - size(*(largest - 1));
    if (largest + 1 != points.end())
        change = std::max(change, size(*largest) - size(*(largest + 1)));
    return Measured{size(*largest), doubt + change};
}

/// The integral of the square of a straight line between two errors, divided by the time.
[[nodiscard]] double meanSquare(double a, double b) {
    return (a * a + a * b + b * b) / 3;
}

[[nodiscard]] Figure rmsOf(std::span<const ResponsePoint> points, double end, double doubt) {
    double sum = 0.0, time = 0.0;
    for (std::size_t i = 1; i < points.size() && points[i].seconds <= end; ++i) {
        const double between = points[i].seconds - points[i - 1].seconds;
        sum += between * meanSquare(points[i - 1].error, points[i].error);
        time += between;
    }
    if (time <= 0)
        return tl::unexpected(Unmeasured::TooFewSamples);
    return Measured{std::sqrt(sum / time), doubt};
}

[[nodiscard]] Figure slewOf(std::span<const ResponsePoint> points, const MoveForecast& move, double doubt) {
    if (move.triangular)
        return tl::unexpected(Unmeasured::NoConstantVelocity);
    const double to = move.seconds - move.accelerating;
    return meanOf(points, &ResponsePoint::error, (move.accelerating + to) / 2, to, doubt);
}

}  // namespace

MoveMetrics measureMove(std::span<const ResponsePoint> points, const ResponseTaken& taken,
                        const SettleWindow& window, double timeDoubt) {
    const MoveForecast move =
        forecast(static_cast<double>(taken.goal) - taken.from, taken.pace, taken.gains.sr);
    const auto first = std::ranges::find_if(points, [](const auto& point) { return point.seconds > 0; });
    const auto during = points.subspan(static_cast<std::size_t>(first - points.begin()));
    if (during.size() <= kFewestForMean) {
        const auto none = tl::unexpected(Unmeasured::TooFewSamples);
        return {move.seconds, none, none, none, none};
    }
    const double usual =
        (during.back().seconds - during.front().seconds) / static_cast<double>(during.size() - 1);
    const double doubt = errorDoubt(move.peakVelocity, taken.gains.sr);
    // The chip begins within a servo tick, and in each one it moves at the velocity of its end: the profile
    // ends up to two servo ticks before its computed time is over.
    const double tick = secondsPerTick(taken.gains.sr);
    return {move.seconds,
            settlingOf(during, taken.goal, move.seconds - tick, usual, window, timeDoubt + tick),
            peakOf(during, 2 * doubt), rmsOf(during, move.seconds, doubt), slewOf(during, move, doubt)};
}

}  // namespace nmc
