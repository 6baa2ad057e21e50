// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/status.h"
#include "protocol/steppercommands.h"

namespace nmc {

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

/// True if a mode of Table 4 has such a load.
[[nodiscard]] bool inTable4(const stepper::LoadTrajectory& load);

/// True if a load may be started on a PIC-STEP in that mode; a change of direction in motion is not allowed
/// (DS-S 4.1). Pure.
[[nodiscard]] bool mayFollow(StepperMode mode, bool runsReverse, const stepper::LoadTrajectory& load);

/// The motion that a PIC-STEP was last started on. The caller decides whether a start counts that was sent,
/// or only one that was answered.
struct StepperRun {
    std::optional<StepperMode> mode;   ///< empty: Table 4 has no such start
    std::optional<std::int32_t> goal;  ///< steps; empty: a motion without an end
    std::optional<bool> reverse;       ///< empty: unknown, as the position was

    /// `from`: the mode in which it was started; `position`: where, if known.
    void start(const stepper::LoadTrajectory& load, StepperMode from, std::optional<std::int32_t> position);
    /// The mode of a module that moves: as its status shows it, and otherwise as it was started.
    [[nodiscard]] StepperMode modeNow(stepper::StatusByte status) const;
};

}  // namespace nmc
