// SPDX-License-Identifier: MIT
#include "bus/stepgate.h"

namespace nmc::bus {

std::optional<StepMode> goalMode(StepMode from, const step::LoadTrajectory& load) {
    const bool profile = load.speed || load.accelerationTime;
    if (from == StepMode::Stopped) {
        if (!load.timer)
            return load.position ? StepMode::Trapezoidal : StepMode::VelocityProfile;
        if (profile)
            return std::nullopt;
        return load.position ? StepMode::UnprofiledWithStop : StepMode::Unprofiled;
    }
    if (load.position || from == StepMode::Unknown)
        return std::nullopt;
    if (from == StepMode::Trapezoidal) {
        if (!load.timer)
            return std::nullopt;
        return profile ? StepMode::VelocityProfile : StepMode::UnprofiledWithStop;
    }
    if (!load.timer)
        return StepMode::VelocityProfile;
    if (profile)
        return std::nullopt;
    return from == StepMode::UnprofiledWithStop ? from : StepMode::Unprofiled;
}

bool mayFollow(StepMode mode, bool runsReverse, const step::LoadTrajectory& load) {
    return goalMode(mode, load) && (mode == StepMode::Stopped || load.reverse == runsReverse);
}

}  // namespace nmc::bus
