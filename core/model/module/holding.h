// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace nmc {

struct ModuleState;

/// A PIC-SERVO that is to hold one position, and is off it.
struct Holding {
    std::int64_t off = 0;  ///< counts: the position that is held less where the motor is
    /// What the error comes to, with all of the integral, is the output limit or more (DS-V 4.3): it pushes
    /// against something.
    bool atLimit = false;

    bool operator==(const Holding&) const = default;
};

/// Empty: it holds within two counts, which friction may well leave, does not hold a position that is known,
/// or has not calmed down since its last motion. Pure.
[[nodiscard]] std::optional<Holding> holdingOf(const ModuleState& module);

}  // namespace nmc
