// SPDX-License-Identifier: MIT
#include "protocol/pathpoint.h"

#include <cstdlib>

namespace nmc::servo {

namespace {

constexpr unsigned kReverse = 0x01;
constexpr unsigned kLonger = 0x02;  ///< F

/// The word holds the speed in 1/256 count per tick: counts x 256 / ticks.
unsigned scaleOf(PathRate rate) {
    return 256U / static_cast<unsigned>(ticksPerPoint(rate));
}

PathRate rateOf(bool longer, bool fastPath) {
    if (fastPath)
        return longer ? PathRate::Hz60 : PathRate::Hz120;
    return longer ? PathRate::Hz30 : PathRate::Hz60;
}

}  // namespace

std::optional<std::uint16_t> toPathWord(const PathPoint& point, bool fastPath) {
    if (point.counts < -maxPathCounts(point.rate) || point.counts > maxPathCounts(point.rate))
        return std::nullopt;
    for (const bool longer : {false, true})
        if (rateOf(longer, fastPath) == point.rate)
            return static_cast<std::uint16_t>(static_cast<unsigned>(std::abs(point.counts)) *
                                                  scaleOf(point.rate) |
                                              (longer ? kLonger : 0U) | (point.counts < 0 ? kReverse : 0U));
    return std::nullopt;
}

}  // namespace nmc::servo
