// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/path/pathtable.h"

namespace nmc {

/// A path computed from moves: in a straight line from each position to the next, all axes at the same time,
/// from standstill to standstill with a trapezoidal velocity profile.
struct PathMoves {
    struct Axis {
        ModuleIndex module;
        double velocity = 0.0;            ///< limit for each move, counts/s; above 0
        double acceleration = 0.0;        ///< limit for each move, counts/s^2
        std::int32_t from = 0;            ///< the command position at which it holds
        std::vector<std::int32_t> goals;  ///< counts; the number is the same for all axes
    };
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<Axis> axes;
};

/// Computes the points at the chip's real rate of 30.5, 61.0 or 122.1 Hz; each goal is exactly one of them.
/// The axis for which a move takes longest moves at its limits, the others as the line requires. A move in
/// which no axis moves yields no points. Pure.
[[nodiscard]] PathTable pathFromMoves(const PathMoves& moves);

}  // namespace nmc
