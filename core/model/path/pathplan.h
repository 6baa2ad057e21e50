// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <tl/expected.hpp>

#include "bus/path.h"
#include "model/intent/intent.h"
#include "model/module/modulestate.h"
#include "model/path/pathshare.h"
#include "model/path/pathtable.h"

/// Converts a table of positions to a path that can be requested: before anything is sent, every precondition
/// of a move is checked for every axis, and the load on the bus. Pure.
namespace nmc {

/// Why a path is not possible now, with the data needed to report it.
struct PathObstacle {
    enum class Kind : std::uint8_t {
        Refused,  ///< the precondition `refusal` of a move: operator rights, servo off, moving, silent, ...
        NoPathBuffer,      ///< not available up to version 4
        ControlUnknown,    ///< found as another host left it; send I/O Control first
        StepAndDirection,  ///< SC: the command position is not under the host's sole control
        WrongFastPath,     ///< the rate needs fast path on (120 Hz) or off (30 Hz)
        ServoRate,         ///< SR is `value`, not 1, so the points would be executed more slowly
        PlaceUnknown,      ///< the command position has not been reported yet
        TooFarToStart,     ///< the first point is `value` counts away, and a segment allows `allowed`: move
                           ///< there first
        Jump,              ///< `point` is `value` counts from the previous one, more than `allowed`
        TooFast,           ///< `point` requires `value` counts per tick; the axis allows `allowed`
        BeyondTravel,      ///< `point` is at `value` counts; the limit is `allowed`
        NoPoints,          ///< no points, different numbers of points, or an axis twice
        NotAGroup,         ///< several axes start together as a group, which must have no other members
        BusTooSlow,        ///< the path needs the fraction `value` of the bus time; `allowed` is available
    };
    Kind kind = Kind::Refused;
    std::optional<ModuleIndex> module{};
    std::optional<Refusal> refusal{};
    std::size_t point = 0;  ///< counted from 1
    double value = 0.0;
    double allowed = 0.0;
    bool operator==(const PathObstacle&) const = default;
};

/// Checks one axis, starting from where it holds now.
[[nodiscard]] std::optional<PathObstacle> obstacle(const bus::PathAxis& axis, servo::PathRate rate,
                                                   const ModuleState& module);

/// `modules`: the entire chain, which is polled besides the path.
[[nodiscard]] tl::expected<intent::FollowPath, PathObstacle> planPath(const PathTable& table,
                                                                      std::span<const ModuleState> modules,
                                                                      const PathLine& line);

/// Checks the first axis of a path again; the bus checks the other axes before it sends anything.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::FollowPath& follow, const ModuleState& module);

}  // namespace nmc
