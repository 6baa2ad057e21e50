// SPDX-License-Identifier: MIT
#include "model/intent/pace.h"

#include <algorithm>

#include "model/module/servodefaults.h"
#include "model/module/stepperdefaults.h"

namespace nmc {

Pace paceOf(const ModuleState& module, const AxisSettings& settings, double share) {
    if (module.isStepper()) {
        const double velocity = settings.motion.velocity > 0
                                    ? settings.motion.velocity
                                    : stepperdefaults::atMost(stepperdefaults::kMove, settings);
        return bus::StepperPace{stepperdefaults::speedFor(velocity * share, module.stepper, settings),
                                stepperdefaults::accelerationTime(settings)};
    }
    const MotionSettings motion = servodefaults::motionOf(settings);
    return ServoPace{CountsPerTick(std::max(1U, servodefaults::toFixed(motion.velocity * share))),
                     CountsPerTickSquared(servodefaults::toFixed(motion.acceleration))};
}

}  // namespace nmc
