// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/stepcommands.h"

namespace nmc::bus {

/// What a PIC-STEP is doing (DS-S 5.1, Table 4).
enum class StepMode : std::uint8_t {
    Stopped,
    Trapezoidal,
    VelocityProfile,
    UnprofiledWithStop,
    Unprofiled,  ///< without a stop
    Unknown,     ///< it moves, and another host told it how
};

/// The mode that a load leads to from standstill; nothing where Table 4 has no such cell.
[[nodiscard]] std::optional<StepMode> goalMode(const step::LoadTrajectory& load);

/// Whether a load may be given to a PIC-STEP in that mode. What the table leaves open while it moves, and a
/// change of direction, is refused (DS-S 4.1). Pure.
[[nodiscard]] bool mayFollow(StepMode mode, bool runsReverse, const step::LoadTrajectory& load);

}  // namespace nmc::bus
