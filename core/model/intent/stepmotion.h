// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <variant>

#include "bus/stepgate.h"
#include "protocol/stepcommands.h"

/// The four ways a PIC-STEP moves, as values (DS-S 4.1 to 4.3).
namespace nmc::stepmotion {

/// Accelerates, runs, decelerates, and ends at the position.
struct Trapezoid {
    std::int32_t position = 0;  ///< steps
    bool relative = false;      ///< from where it stands when it starts
    std::uint8_t speed = 1;     ///< 1..250
    std::uint8_t accelerationTime = 1;
    bool operator==(const Trapezoid&) const = default;
};
/// Ramps to a speed and keeps it until it is stopped.
struct VelocityProfile {
    std::uint8_t speed = 1;
    std::uint8_t accelerationTime = 1;
    bool reverse = false;
    bool operator==(const VelocityProfile&) const = default;
};
/// At one speed to the position, where it stops at once.
struct UnprofiledMove {
    std::int32_t position = 0;
    bool relative = false;
    step::TimerCount timer;
    bool operator==(const UnprofiledMove&) const = default;
};
/// At one speed until it is stopped.
struct UnprofiledRun {
    step::TimerCount timer;
    bool reverse = false;
    bool operator==(const UnprofiledRun&) const = default;
};

}  // namespace nmc::stepmotion

namespace nmc {

using StepMotion = std::variant<stepmotion::Trapezoid, stepmotion::VelocityProfile,
                                stepmotion::UnprofiledMove, stepmotion::UnprofiledRun>;

}  // namespace nmc
