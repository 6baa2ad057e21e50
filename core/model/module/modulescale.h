// SPDX-License-Identifier: MIT
#pragma once

#include "model/module/modulestate.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {

/// The scale of an axis: a PIC-SERVO counts in ticks, whose length depends on the servo rate; a PIC-STEP in
/// seconds.
[[nodiscard]] inline AxisScale scaleOf(const ModuleState& module, const AxisSettings& settings) {
    if (!module.isServo())
        return AxisScale::step(settings.unit);
    return AxisScale::servo(settings.unit, module.servoRate);
}

}  // namespace nmc
