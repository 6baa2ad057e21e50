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

/// Why a sequence makes no path. Its rows are counted from 0.
struct DrawingProblem {
    enum class Kind : std::uint8_t {
        NoPathAxis,    ///< `module`, which a row moves, follows no path
        PlaceUnknown,  ///< of `module`: the command position that it holds, or a goal
        NotDrawn,      ///< a row that is neither a move, a wait, a repeat nor a call
        Endless,       ///< a row that repeats for ever
        TooManyPoints,
        NoMove,  ///< it has none
    };
    Kind kind = Kind::NoMove;
    std::string sequence{};
    std::size_t row = 0;
    std::optional<ModuleIndex> module{};
    bool operator==(const DrawingProblem&) const = default;
};

/// The moves of a sequence without a stop between its commands: from where its axes hold now, each move at
/// its share of the axes' own velocity and acceleration, in a straight line; a wait is a rest. Every axis
/// that it moves anywhere has a column. Pure.
[[nodiscard]] tl::expected<PathTable, DrawingProblem> drawPath(const std::string& sequence,
                                                               const Machine& machine,
                                                               const std::vector<ModuleState>& modules,
                                                               servo::PathRate rate);

}  // namespace nmc
