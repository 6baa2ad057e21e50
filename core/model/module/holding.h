// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace nmc {

struct ModuleState;

/// A PIC-SERVO that should hold a position, but is off it.
struct Holding {
    std::int64_t off = 0;  ///< counts: the position to hold minus the motor's position
    /// The error, with the full integral, demands the output limit or more (DS-V 4.3): the motor pushes
    /// against something.
    bool atLimit = false;

    bool operator==(const Holding&) const = default;
};

/// Empty if the servo holds within two counts, which friction may well leave; if it holds no known position;
/// or if it has not settled since its last motion. Pure.
[[nodiscard]] std::optional<Holding> holdingOf(const ModuleState& module);

}  // namespace nmc
