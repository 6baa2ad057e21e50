// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/steppercommands.h"

namespace nmc::bus {

/// The present mode of a PIC-STEP (DS-S 5.1, Table 4).
enum class StepperMode : std::uint8_t {
    Stopped,
    Trapezoidal,
    VelocityProfile,
    UnprofiledWithStop,
    Unprofiled,  ///< without a stop
    Unknown,     ///< moving in a way that another host commanded
};

/// The mode to which a load leads from the given mode; empty if Table 4 has no such cell. With only a timer
/// count, a move to a position keeps its goal: the data sheet allows no unprofiled run from there.
[[nodiscard]] std::optional<StepperMode> goalMode(StepperMode from, const stepper::LoadTrajectory& load);

/// True if a load may be started on a PIC-STEP in that mode; a change of direction in motion is not allowed
/// (DS-S 4.1). Pure.
[[nodiscard]] bool mayFollow(StepperMode mode, bool runsReverse, const stepper::LoadTrajectory& load);

}  // namespace nmc::bus
