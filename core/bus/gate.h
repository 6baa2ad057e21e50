// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "bus/belief.h"

namespace nmc::bus {

/// Whether a command may be sent to a module.
enum class Permission : std::uint8_t {
    Allowed,
    NeedsStatus,  ///< unknown: read the full status, then try again
    InMotion,     ///< not while the module moves according to its last status
    Never,        ///< not for this chip, or not in this form
};

/// Applies the rules of DS-V 4.4 and 5.1, DS-S 5.1, and of link.md: a trapezoidal move is started only from
/// standstill, and no move to a position by the command that loads it, so that a garbled goal never moves
/// anything; Start Motion is sent only after a load that was answered; addresses, rate and reset belong to
/// the engine. Pure.
[[nodiscard]] Permission permit(const Belief& belief, const ModuleCommand& command);

/// Whether points may be put into the module's path buffer and started: only by a path, from standstill, with
/// the servo on. Never if I/O Control is unknown, or is set to another rate or to step and direction.
[[nodiscard]] Permission mayFollowPath(const Belief& belief, servo::PathRate rate);

}  // namespace nmc::bus
