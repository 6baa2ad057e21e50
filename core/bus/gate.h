// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "bus/belief.h"

namespace nmc::bus {

/// Whether a command may go out to a module.
enum class Permission : std::uint8_t {
    Allowed,
    NeedsStatus,  ///< not known: read the full status, then ask again
    InMotion,     ///< not while it moves, as far as the last status tells
    Never,        ///< not for this chip, or not in this form
};

/// The rules of DS-V 4.4 and 5.1, DS-S 5.1, and of link.md: a trapezoidal move is started from standstill
/// only, and never by the command that loads it, so that a garbled load never moves anything; Start Motion
/// only after a load that was answered; addresses, rate and reset belong to the engine. Pure.
[[nodiscard]] Permission permit(const Belief& belief, const ModuleCommand& command);

/// Whether points may be laid into its path buffer and started: by a path alone, from standstill, with the
/// servo on. Never where I/O Control is not known, or wants another rate or step and direction.
[[nodiscard]] Permission mayFollowPath(const Belief& belief, servo::PathRate rate);

}  // namespace nmc::bus
