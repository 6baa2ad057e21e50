// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/servocommands.h"
#include "protocol/steppercommands.h"

/// Loads of profiled motions: to a goal, or without an end, for which alone `reverse` counts. They wait for a
/// start.
namespace nmc {

[[nodiscard]] servo::LoadTrajectory profiledLoad(CountsPerTick velocity, CountsPerTickSquared acceleration,
                                                 std::optional<std::int32_t> goal, bool reverse = false);
[[nodiscard]] stepper::LoadTrajectory profiledLoad(std::uint8_t speed, std::uint8_t accelerationTime,
                                                   std::optional<std::int32_t> goal, bool reverse = false);

}  // namespace nmc
