// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "bus/path.h"
#include "model/intent/intent.h"
#include "model/module/modulestate.h"
#include "model/path/pathshare.h"
#include "model/path/pathtable.h"

/// From a table of positions to a path that can be asked for: every rule that a move has to keep is asked for
/// every axis, and the bus for its time, before anything is sent. Pure.
namespace nmc {

/// Why a path is not possible now, with what the sentence about it needs.
struct PathObstacle {
    enum class Kind : std::uint8_t {
        Refused,       ///< `refusal` says why, as of a move: operator rights, servo off, moving, silent, ...
        NoPathBuffer,  ///< up to version 4
        ControlUnknown,    ///< found as another host left it: set I/O Control first
        StepAndDirection,  ///< of an SC: its command position is not the host's alone
        WrongFastPath,     ///< the rate needs fast path on (120 Hz) or off (30 Hz)
        ServoRate,         ///< SR is not 1, so the points would come later: `value`
        PlaceUnknown,      ///< the command position was not told yet
        TooFarToStart,     ///< the first point is `value` counts off, and a segment carries `allowed`: move
                           ///< there
        Jump,              ///< `point` is `value` counts from the one before, more than `allowed`
        TooFast,           ///< `point` is; counts per tick, `allowed` by the axis
        BeyondTravel,      ///< `point` is at `value`; the limit is `allowed`
        NoPoints,          ///< or not as many for each axis, or an axis twice
        NotAGroup,         ///< several axes start together as a group that has no other members
        BusTooSlow,        ///< it needs `value` of the time of the bus; `allowed` is available
    };
    Kind kind = Kind::Refused;
    std::optional<ModuleIndex> module{};
    std::optional<Refusal> refusal{};
    std::size_t point = 0;  ///< from 1
    double value = 0.0;
    double allowed = 0.0;
    bool operator==(const PathObstacle&) const = default;
};

/// Of one axis, from where it holds now.
[[nodiscard]] std::optional<PathObstacle> obstacle(const bus::PathAxis& axis, servo::PathRate rate,
                                                   const ModuleState& module);

/// `modules`: all of the chain, which is asked beside the path.
[[nodiscard]] tl::expected<intent::FollowPath, PathObstacle> planPath(const PathTable& table,
                                                                      std::span<const ModuleState> modules,
                                                                      const PathLine& line);

/// The same rule again, of its first axis; the bus asks the others before it sends anything.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::FollowPath& follow, const ModuleState& module);

}  // namespace nmc
