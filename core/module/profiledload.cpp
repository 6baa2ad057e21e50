// SPDX-License-Identifier: MIT
#include "module/profiledload.h"

namespace nmc {

servo::LoadTrajectory profiledLoad(CountsPerTick velocity, CountsPerTickSquared acceleration,
                                   std::optional<std::int32_t> goal, bool reverse) {
    servo::LoadTrajectory load;
    if (goal)
        load.position = Counts(*goal);
    load.velocity = velocity;
    load.acceleration = acceleration;
    load.profile = goal ? servo::ProfileMode::Trapezoidal : servo::ProfileMode::Velocity;
    load.reverse = !goal && reverse;
    return load;
}

stepper::LoadTrajectory profiledLoad(std::uint8_t speed, std::uint8_t accelerationTime,
                                     std::optional<std::int32_t> goal, bool reverse) {
    stepper::LoadTrajectory load;
    if (goal)
        load.position = Counts(*goal);
    load.speed = speed;
    load.accelerationTime = accelerationTime;
    load.reverse = !goal && reverse;
    return load;
}

}  // namespace nmc
