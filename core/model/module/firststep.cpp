// SPDX-License-Identifier: MIT
#include "model/module/firststep.h"

namespace nmc {

std::optional<FirstStep> nextFirstStep(const ModuleState& module, const AxisSettings& axis) {
    if (!module.isServo() || (module.gains && module.canDecelerate()))
        return std::nullopt;
    if (!module.gains)
        return axis.gains ? FirstStep::ApplyGains : FirstStep::FillInGains;
    return module.servoOn() ? FirstStep::Jog : FirstStep::Enable;
}

}  // namespace nmc
