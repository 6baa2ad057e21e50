// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/steppercommands.h"

namespace nmc::bus {

/// What a PIC-STEP is doing (DS-S 5.1, Table 4).
enum class StepperMode : std::uint8_t {
    Stopped,
    Trapezoidal,
    VelocityProfile,
    UnprofiledWithStop,
    Unprofiled,  ///< without a stop
    Unknown,     ///< it moves, and another host told it how
};

/// The mode that a load leads to from that mode; nothing where Table 4 has no such cell. With a timer count
/// alone, a move to a position keeps its goal: the sheet allows no unprofiled run from there.
[[nodiscard]] std::optional<StepperMode> goalMode(StepperMode from, const stepper::LoadTrajectory& load);

/// Whether a load may be started on a PIC-STEP in that mode; a change of direction in motion is refused (DS-S
/// 4.1). Pure.
[[nodiscard]] bool mayFollow(StepperMode mode, bool runsReverse, const stepper::LoadTrajectory& load);

}  // namespace nmc::bus
