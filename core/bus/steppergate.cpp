// SPDX-License-Identifier: MIT
#include "bus/steppergate.h"

namespace nmc::bus {

std::optional<StepperMode> goalMode(StepperMode from, const stepper::LoadTrajectory& load) {
    const bool profile = load.speed || load.accelerationTime;
    if (from == StepperMode::Stopped) {
        if (!load.timer)
            return load.position ? StepperMode::Trapezoidal : StepperMode::VelocityProfile;
        if (profile)
            return std::nullopt;
        return load.position ? StepperMode::UnprofiledWithStop : StepperMode::Unprofiled;
    }
    if (load.position || from == StepperMode::Unknown)
        return std::nullopt;
    if (from == StepperMode::Trapezoidal) {
        if (!load.timer)
            return std::nullopt;
        return profile ? StepperMode::VelocityProfile : StepperMode::UnprofiledWithStop;
    }
    if (!load.timer)
        return StepperMode::VelocityProfile;
    if (profile)
        return std::nullopt;
    return from == StepperMode::UnprofiledWithStop ? from : StepperMode::Unprofiled;
}

bool mayFollow(StepperMode mode, bool runsReverse, const stepper::LoadTrajectory& load) {
    return goalMode(mode, load) && (mode == StepperMode::Stopped || load.reverse == runsReverse);
}

}  // namespace nmc::bus
