// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "bus/types.h"

/// How a motor moves, as values. A relative position is relative to the position at which the motion starts.
namespace nmc {

/// The motions of a PIC-SERVO (DS-V 4.4).
namespace servomotion {

/// Accelerates, runs, decelerates and ends at the position.
struct Trapezoid {
    Counts position;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
};
/// Accelerates to a velocity and keeps it until stopped.
struct VelocityProfile {
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool reverse = false;
};

}  // namespace servomotion

/// The four kinds of motion of a PIC-STEP (DS-S 4.1 to 4.3).
namespace steppermotion {

/// Accelerates, runs, decelerates and ends at the position.
struct Trapezoid {
    std::int32_t position = 0;  ///< steps
    bool relative = false;
    std::uint8_t speed = 1;  ///< 1..250
    std::uint8_t accelerationTime = 1;
    bool operator==(const Trapezoid&) const = default;
};
/// Ramps to a speed and keeps it until stopped.
struct VelocityProfile {
    std::uint8_t speed = 1;
    std::uint8_t accelerationTime = 1;
    bool reverse = false;
    bool operator==(const VelocityProfile&) const = default;
};
/// Moves at constant speed to the position, where it stops at once.
struct UnprofiledMove {
    std::int32_t position = 0;
    bool relative = false;
    stepper::TimerCount timer;
    bool operator==(const UnprofiledMove&) const = default;
};
/// Runs at constant speed until stopped.
struct UnprofiledRun {
    stepper::TimerCount timer;
    bool reverse = false;
    bool operator==(const UnprofiledRun&) const = default;
};

}  // namespace steppermotion

using ServoMotion = std::variant<servomotion::Trapezoid, servomotion::VelocityProfile>;
using StepperMotion = std::variant<steppermotion::Trapezoid, steppermotion::VelocityProfile,
                                   steppermotion::UnprofiledMove, steppermotion::UnprofiledRun>;
using MotionSpec = std::variant<ServoMotion, StepperMotion>;

/// How fast a motor makes trapezoidal moves.
struct ServoPace {
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool operator==(const ServoPace&) const = default;
};
using Pace = std::variant<ServoPace, bus::StepperPace>;

/// A trapezoidal move to a position.
[[nodiscard]] MotionSpec moveTo(std::int32_t position, const Pace& pace);
/// Where a motion that starts at `from` ends, in 64 bits so that excessive distances can be detected; empty
/// for a motion without an end.
[[nodiscard]] std::optional<std::int64_t> goalOf(const MotionSpec& motion, std::int32_t from);
/// The same kind of motion with another end; one without an end is unchanged.
[[nodiscard]] MotionSpec endingAt(std::int32_t position, MotionSpec motion);

}  // namespace nmc
