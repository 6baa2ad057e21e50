// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/module/modulestate.h"

namespace nmc {

/// Where a move has to turn round, so that it comes to its goal from the side that the axis wants
/// (BacklashSettings); nothing: it comes from there anyway. A way in that direction that is shorter than the
/// play may not have taken it up, unless the motor rests where a move from that side has led. Pure.
[[nodiscard]] std::optional<std::int64_t> turningPoint(std::int64_t from, std::int64_t goal,
                                                       const ModuleState& module);

}  // namespace nmc
