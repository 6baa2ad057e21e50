// SPDX-License-Identifier: MIT
#pragma once

#include "model/module/modulestate.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {

/// A PIC-SERVO counts in ticks that its servo rate stretches; a PIC-STEP in seconds.
[[nodiscard]] inline AxisScale scaleOf(const ModuleState& module, const AxisSettings& settings) {
    if (!module.isServo())
        return AxisScale::step(settings.unit);
    return AxisScale::servo(settings.unit, module.servoRate);
}

}  // namespace nmc
