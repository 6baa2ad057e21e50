// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "bus/steppergate.h"
#include "protocol/steppercommands.h"

/// The four kinds of motion of a PIC-STEP, as values (DS-S 4.1 to 4.3).
namespace nmc::steppermotion {

/// Accelerates, runs, decelerates and ends at the position.
struct Trapezoid {
    std::int32_t position = 0;  ///< steps
    bool relative = false;      ///< relative to the position when it starts
    std::uint8_t speed = 1;     ///< 1..250
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

}  // namespace nmc::steppermotion

namespace nmc {

using StepperMotion = std::variant<steppermotion::Trapezoid, steppermotion::VelocityProfile,
                                   steppermotion::UnprofiledMove, steppermotion::UnprofiledRun>;

}  // namespace nmc
