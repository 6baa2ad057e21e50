// SPDX-License-Identifier: MIT
#include "model/procedure/repeatability.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/strong.h"

namespace nmc {

namespace {

/// Positions wrap at 32 bits, so they are taken relative to `origin`.
[[nodiscard]] EdgeSpread spreadOf(std::span<const std::int32_t> captures, std::int32_t origin, double late) {
    const auto count = static_cast<double>(captures.size());
    double sum = 0.0;
    std::int32_t lowest = countsBetween(origin, captures.front());
    std::int32_t highest = lowest;
    for (const std::int32_t capture : captures) {
        const std::int32_t from = countsBetween(origin, capture);
        sum += from;
        lowest = std::min(lowest, from);
        highest = std::max(highest, from);
    }
    const double mean = sum / count;
    double squares = 0.0;
    for (const std::int32_t capture : captures)
        squares += std::pow(countsBetween(origin, capture) - mean, 2);
    return {origin + mean - late, std::sqrt(squares / (count - 1.0)),
            static_cast<double>(highest) - static_cast<double>(lowest)};
}

/// Student's t for 95 % to both sides (Abramowitz and Stegun, 26.7.5), 0.8 % low for two degrees of freedom.
[[nodiscard]] double student(double freedom) {
    const double f = 1.0 / freedom;
    return 1.960 + f * (2.372 + f * (2.822 + f * (2.556 + f * 1.589)));
}

}  // namespace

std::optional<Repeatability> repeatabilityOf(const EdgeCaptures& edges) {
    if (edges.forward.size() < 2 || edges.reverse.size() < 2)
        return std::nullopt;
    const std::int32_t origin = edges.forward.front();
    const double late = edges.perReading / edges.readings / 2.0;
    Repeatability found{.forward = spreadOf(edges.forward, origin, late),
                        .reverse = spreadOf(edges.reverse, origin, -late)};
    const auto forward = static_cast<double>(edges.forward.size());
    const auto reverse = static_cast<double>(edges.reverse.size());
    const double error = std::hypot(found.forward.deviation / std::sqrt(forward),
                                    found.reverse.deviation / std::sqrt(reverse));
    found.backlash = found.forward.mean - found.reverse.mean;
    found.uncertainty = 1.0 + edges.perReading + student(forward + reverse - 2.0) * error;
    return found;
}

}  // namespace nmc
