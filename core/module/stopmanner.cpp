// SPDX-License-Identifier: MIT
#include "module/stopmanner.h"

namespace nmc {

StopManner firmer(StopManner one, StopManner other) {
    for (const StopManner firm : {StopManner::Off, StopManner::Abruptly})
        if (one == firm || other == firm)
            return firm;
    return StopManner::Smoothly;
}

ModuleCommand stopMotor(ModuleType chip, StopManner manner, bool amplifier) {
    const bool smoothly = manner == StopManner::Smoothly;
    if (chip == ModuleType::Stepper)
        return StepperCommand(
            stepper::StopMotor{amplifier && manner != StopManner::Off,
                               smoothly ? stepper::StopManner::Smoothly : stepper::StopManner::Abruptly});
    if (manner == StopManner::Off)
        return ServoCommand(servo::StopMotor{false, servo::StopManner::MotorOff, {}});
    return ServoCommand(servo::StopMotor{
        amplifier, smoothly ? servo::StopManner::Smoothly : servo::StopManner::Abruptly, {}});
}

std::optional<StopManner> stopManner(const ModuleCommand& command) {
    if (const auto* stop = getIf<servo::StopMotor>(command))
        switch (stop->manner) {
            case servo::StopManner::AmplifierOnly:
                return std::nullopt;
            case servo::StopManner::MotorOff:
                return StopManner::Off;
            case servo::StopManner::Smoothly:
                return StopManner::Smoothly;
            case servo::StopManner::Abruptly:
            case servo::StopManner::Here:
                return StopManner::Abruptly;
        }
    if (const auto* stop = getIf<stepper::StopMotor>(command)) {
        if (!stop->amplifierEnable)
            return StopManner::Off;
        switch (stop->manner) {
            case stepper::StopManner::AmplifierOnly:
                return std::nullopt;
            case stepper::StopManner::Abruptly:
                return StopManner::Abruptly;
            case stepper::StopManner::Smoothly:
                return StopManner::Smoothly;
        }
    }
    return std::nullopt;
}

}  // namespace nmc
