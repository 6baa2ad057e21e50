// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/motion.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// How fast an axis makes its moves: at its own velocity and acceleration (MotionSettings), or at slow ones
/// if it has none yet; `share` of the velocity, 0 to 1. Pure.
[[nodiscard]] Pace paceOf(const ModuleState& module, const AxisSettings& settings, double share = 1.0);

}  // namespace nmc
