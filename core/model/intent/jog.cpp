// SPDX-License-Identifier: MIT
#include "model/intent/jog.h"

#include <algorithm>

#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "model/module/servodefaults.h"
#include "model/module/stepperdefaults.h"

namespace nmc {

JogRange jogRange(const ModuleState& module, const AxisSettings& axis) {
    if (module.isStepper()) {
        const double slowest = stepperdefaults::slowestProfile(module.stepper, axis);
        const double cap = stepperdefaults::holdCap(module.stepper, axis);
        return {slowest, cap, std::clamp(stepperdefaults::kHold, slowest, cap)};
    }
    const MotionSettings motion = servodefaults::motionOf(axis);
    return {servodefaults::kSmallest, motion.holdCap, std::min(motion.holdVelocity, motion.holdCap)};
}

std::optional<bus::HoldToMove> jog(const ModuleState& module, const AxisSettings& axis, double speed,
                                   bool reverse) {
    bus::HoldToMove hold;
    hold.module = module.info.index;
    hold.reverse = reverse;
    if (!module.isStepper()) {
        hold.velocity = CountsPerTick(servodefaults::toFixed(speed));
        hold.acceleration =
            CountsPerTickSquared(servodefaults::toFixed(servodefaults::motionOf(axis).acceleration));
        return hold;
    }
    const auto& parameters = module.stepper.parameters;
    if (!parameters)
        return std::nullopt;
    hold.pace = bus::StepperPace{StepperSpeed(parameters->speedMode).speedBelow(speed),
                                 stepperdefaults::accelerationTime(axis)};
    return hold;
}

std::uint32_t nextPress() {
    static std::uint32_t presses = 0;
    return ++presses;
}

std::optional<Refusal> whyNot(const bus::HoldToMove& hold, const ModuleState& module) {
    if (const auto refusal = whyNot(IntentKind::Hold, module))
        return refusal;
    const MotionSpec run = runOf(hold);
    if (const auto* steps = std::get_if<StepperMotion>(&run))
        // Towards a travel limit, the bus first stops a motor that moves.
        return travelEnd(module, hold.reverse) ? whyNotFromStandstill(*steps, module, IntentKind::Hold)
                                               : whyNot(*steps, module, IntentKind::Hold);
    if (module.limitEnds(hold.reverse ? -1 : 1))
        return Refusal::LimitClosed;
    const auto problem = travelProblem(intent::Move{run}, module);
    return problem ? std::optional(problem->refusal) : std::nullopt;
}

MotionSpec runOf(const bus::HoldToMove& hold) {
    if (hold.pace)
        return StepperMotion(
            steppermotion::VelocityProfile{hold.pace->speed, hold.pace->accelerationTime, hold.reverse});
    return ServoMotion(servomotion::VelocityProfile{hold.velocity, hold.acceleration, hold.reverse});
}

Pace paceOf(const bus::HoldToMove& hold) {
    if (hold.pace)
        return *hold.pace;
    return ServoPace{hold.velocity, hold.acceleration};
}

}  // namespace nmc
