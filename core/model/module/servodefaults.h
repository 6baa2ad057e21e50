// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "model/settings/machine.h"

/// How a servo moves by hand while the user has said nothing. Counts per tick: about 1950, 980 and 490
/// counts/s at the fastest servo rate; a slow turn of a common encoder.
namespace nmc::servodefaults {

inline constexpr double kVelocity = 1.0;
inline constexpr double kRunVelocity = 0.5;
inline constexpr double kHoldVelocity = 0.25;
inline constexpr double kAcceleration = 0.002;
/// Hold to move goes no faster until an engineer says so.
inline constexpr double kHoldCap = 2.0;
/// 16.16 fixed point (DS-V 4.4).
inline constexpr double kFixedPoint = 65536.0;
inline constexpr double kLargest = 32767.0;
inline constexpr double kSmallest = 1.0 / kFixedPoint;

/// What is not set is replaced by the above.
[[nodiscard]] inline MotionSettings motionOf(const AxisSettings& settings) {
    MotionSettings motion = settings.motion;
    const auto begin = [](double& value, double first) {
        if (value == 0.0)
            value = first;
    };
    begin(motion.velocity, kVelocity);
    begin(motion.runVelocity, kRunVelocity);
    begin(motion.acceleration, kAcceleration);
    begin(motion.holdCap, kHoldCap);
    begin(motion.holdVelocity, kHoldVelocity);
    return motion;
}

[[nodiscard]] inline std::uint32_t toFixed(double value) {
    return static_cast<std::uint32_t>(std::llround(value * kFixedPoint));
}

}  // namespace nmc::servodefaults
