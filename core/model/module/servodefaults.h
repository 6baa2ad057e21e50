// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/settings/machine.h"
#include "protocol/takes.h"

/// Default motion of a servo for which the user has set nothing. Counts per tick: about 1950, 980 and 490
/// counts/s at the fastest servo rate, a slow turn for a common encoder.
namespace nmc::servodefaults {

inline constexpr double kVelocity = 1.0;
inline constexpr double kRunVelocity = 0.5;
inline constexpr double kHoldVelocity = 0.25;
inline constexpr double kAcceleration = 0.002;
/// Hold to move is limited to this velocity until an engineer changes it.
inline constexpr double kHoldCap = 2.0;
/// Range of 16.16 fixed point (DS-V 4.4), and of accelerations.
inline constexpr double kLargest = 32767.0;
inline constexpr double kSmallest = 1.0 / kFixedPointOne;

/// The highest velocity that the chip takes, counts/tick.
[[nodiscard]] inline double fastest(const ModuleIdentity& chip) {
    return std::min(kLargest, static_cast<double>(loadableVelocities(chip).max) / kFixedPointOne);
}
/// The highest velocity set for this axis, counts/tick; kLargest if none is set.
[[nodiscard]] inline double fastest(const AxisSettings& settings) {
    return settings.travel.fastest > 0.0 ? settings.travel.fastest : kLargest;
}

/// Replaces values that are not set by the defaults above. Values that were set are kept even if the axis may
/// no longer move that fast, except for the limit of hold to move.
[[nodiscard]] inline MotionSettings motionOf(const AxisSettings& settings) {
    MotionSettings motion = settings.motion;
    const auto begin = [most = fastest(settings)](double& value, double first) {
        if (value == 0.0)
            value = std::min(first, most);
    };
    begin(motion.velocity, kVelocity);
    begin(motion.runVelocity, kRunVelocity);
    if (motion.acceleration == 0.0)
        motion.acceleration = kAcceleration;
    begin(motion.holdCap, kHoldCap);
    motion.holdCap = std::min(motion.holdCap, fastest(settings));
    begin(motion.holdVelocity, kHoldVelocity);
    return motion;
}

[[nodiscard]] inline std::uint32_t toFixed(double value) {
    return static_cast<std::uint32_t>(std::llround(value * kFixedPointOne));
}

}  // namespace nmc::servodefaults
