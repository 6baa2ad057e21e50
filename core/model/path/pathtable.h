// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/strong.h"
#include "protocol/pathpoint.h"

namespace nmc {

/// Positions of one or more axes, in counts, at a fixed rate.
struct PathTable {
    struct Column {
        ModuleIndex module;
        std::vector<std::int32_t> points;
        bool operator==(const Column&) const = default;
    };
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<Column> columns;  ///< all with the same number of points
    bool operator==(const PathTable&) const = default;
};

/// The longest segment, in counts, of a path that goes at most this many counts per tick: points are whole
/// counts, so that at a constant velocity, segments are rounded down and up.
[[nodiscard]] inline double longestSegment(double velocity, servo::PathRate rate) {
    return std::ceil(velocity * servo::ticksPerPoint(rate));
}

}  // namespace nmc
