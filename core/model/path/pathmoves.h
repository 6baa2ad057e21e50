// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "model/path/pathtable.h"

namespace nmc {

/// A path drawn from moves: in a straight line from each place to the next, all axes at the same time, from
/// standstill to standstill in a trapezoid of velocity.
struct PathMoves {
    struct Axis {
        ModuleIndex module;
        double velocity = 0.0;            ///< most of each move, counts/s; above 0
        double acceleration = 0.0;        ///< the same, counts/s^2
        std::int32_t from = 0;            ///< the command position that it holds
        std::vector<std::int32_t> goals;  ///< counts; each axis has as many
    };
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<Axis> axes;
};

/// Its points at the rate of the chip, which is 30.5, 61.0 or 122.1 Hz really; one of them is each goal, to
/// the count. The axis for which a move takes longest goes as fast as it may, the others as the line wants. A
/// move of none is no point. Pure.
[[nodiscard]] PathTable pathFromMoves(const PathMoves& moves);

}  // namespace nmc
