// SPDX-License-Identifier: MIT
#pragma once

#include "model/module/modulestate.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {

/// A PIC-SERVO counts in ticks that its servo rate stretches, as far as that is known; a PIC-STEP in seconds.
[[nodiscard]] inline AxisScale scaleOf(const ModuleState& module, const AxisSettings& settings) {
    if (!module.isServo())
        return AxisScale::step(settings.unit);
    return AxisScale::servo(settings.unit, module.gains ? module.gains->sr : 1);
}

}  // namespace nmc
