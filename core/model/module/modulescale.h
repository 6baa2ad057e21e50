// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

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

/// The same for an axis whose module may be absent (null): then it is the one that is expected, and its servo
/// rate is unknown.
[[nodiscard]] inline AxisScale scaleOf(const ModuleState* module, const AxisSettings& settings,
                                       const std::optional<ModuleIdentity>& expected) {
    if (module != nullptr)
        return scaleOf(*module, settings);
    const bool steps = expected && expected->type == ModuleType::Stepper;
    return steps ? AxisScale::step(settings.unit) : AxisScale::servo(settings.unit, std::nullopt);
}

}  // namespace nmc
