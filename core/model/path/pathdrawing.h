// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "model/module/modulestate.h"
#include "model/path/pathtable.h"
#include "model/settings/machine.h"

namespace nmc {

/// Why no path can be drawn from a sequence. Rows are counted from 0.
struct DrawingProblem {
    enum class Kind : std::uint8_t {
        NoPathAxis,    ///< `module`, which a row moves, cannot follow a path
        PlaceUnknown,  ///< for `module`: the command position at which it holds, or a goal
        NotDrawn,      ///< a row other than a move, a wait, a repeat or a call
        Endless,       ///< a row that repeats forever
        TooManyPoints,
        NoMove,  ///< the sequence contains no move
    };
    Kind kind = Kind::NoMove;
    std::string sequence{};
    std::size_t row = 0;
    std::optional<ModuleIndex> module{};
    bool operator==(const DrawingProblem&) const = default;
};

/// The moves of a sequence without stops between its commands: from the present command positions, each move
/// in a straight line, all axes at the same time, from standstill to standstill with a trapezoidal velocity
/// profile, at its percentage of the axes' own velocity; a wait is a rest. The points are at the chip's real
/// rate of 30.5, 61.0 or 122.1 Hz; each goal is exactly one of them, and a move in which no axis moves yields
/// none. Every axis that the sequence moves has a column. Pure.
[[nodiscard]] tl::expected<PathTable, DrawingProblem> drawPath(const std::string& sequence,
                                                               const Machine& machine,
                                                               const std::vector<ModuleState>& modules,
                                                               servo::PathRate rate);

}  // namespace nmc
