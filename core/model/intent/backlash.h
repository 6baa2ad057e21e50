// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/module/modulestate.h"

namespace nmc {

/// The position at which a move has to turn round so that it arrives at its goal from the side that the axis
/// requires (BacklashSettings); empty if it arrives from there anyway. A move in that direction that is
/// shorter than the play may not take it up, unless the motor already rests where a move from that side has
/// led. Pure.
[[nodiscard]] std::optional<std::int64_t> turningPoint(std::int64_t from, std::int64_t goal,
                                                       const ModuleState& module);

/// The same for a move that begins now. At rest, it begins where the motor holds, and friction that keeps it
/// a few counts away from there is no reason to turn; a motion that is changed on its way goes straight.
[[nodiscard]] std::optional<std::int64_t> turningPoint(std::int64_t goal, const ModuleState& module);

/// The module for a move that goes straight to its goal, such as each of the two that such a turn lies
/// between.
[[nodiscard]] ModuleState withoutBacklash(ModuleState module);

}  // namespace nmc
