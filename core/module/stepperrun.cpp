// SPDX-License-Identifier: MIT
#include "module/stepperrun.h"

namespace nmc {

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

bool inTable4(const stepper::LoadTrajectory& load) {
    return goalMode(StepperMode::Stopped, load) || goalMode(StepperMode::Trapezoidal, load);
}

bool mayFollow(StepperMode mode, bool runsReverse, const stepper::LoadTrajectory& load) {
    return goalMode(mode, load) && (mode == StepperMode::Stopped || load.reverse == runsReverse);
}

void StepperRun::start(const stepper::LoadTrajectory& load, StepperMode from,
                       std::optional<std::int32_t> position) {
    mode = goalMode(from, load);
    // A load with only a timer count leaves the goal of a motion that ends at one (DS-S Table 4).
    if (mode == StepperMode::UnprofiledWithStop && !load.position)
        return;
    goal.reset();
    reverse = load.reverse;
    if (load.position) {
        goal = load.position->value();
        // A trapezoid takes its direction from the goal; for a move without a ramp, the bit agrees with it
        // (docs/protocol.md).
        reverse = position ? std::optional(*goal < *position) : std::nullopt;
    }
}

StepperMode StepperRun::modeNow(stepper::StatusByte status) const {
    if (status.trapezoidalMode())
        return StepperMode::Trapezoidal;
    if (status.velocityMode())
        return StepperMode::VelocityProfile;
    return mode.value_or(StepperMode::Unknown);
}

}  // namespace nmc
