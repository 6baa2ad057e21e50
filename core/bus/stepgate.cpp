// SPDX-License-Identifier: MIT
#include "bus/stepgate.h"

namespace nmc::bus {

std::optional<StepMode> goalMode(const step::LoadTrajectory& load) {
    if (!load.timer)
        return load.position ? StepMode::Trapezoidal : StepMode::VelocityProfile;
    if (load.speed || load.accelerationTime)
        return std::nullopt;
    return load.position ? StepMode::UnprofiledWithStop : StepMode::Unprofiled;
}

bool mayFollow(StepMode mode, bool runsReverse, const step::LoadTrajectory& load) {
    const auto goal = goalMode(load);
    if (!goal)
        return false;
    if (mode == StepMode::Stopped)
        return true;
    // A goal position cannot change in motion, nor can the direction.
    if (load.position || load.reverse != runsReverse)
        return false;
    switch (mode) {
        case StepMode::VelocityProfile:
        case StepMode::Unprofiled:
            return true;
        case StepMode::UnprofiledWithStop:
            return true;  // with a timer count alone it keeps its goal
        case StepMode::Stopped:
        case StepMode::Trapezoidal:
        case StepMode::Unknown:
            break;
    }
    return false;
}

}  // namespace nmc::bus
