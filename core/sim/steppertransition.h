// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "sim/snapshot.h"

namespace nmc::sim {

/// What Load Trajectory commands have left in the chip: the values of all such commands so far, and the
/// control byte of the last.
struct StepperTrajectory {
    static constexpr std::uint8_t kPosition = 0x01;
    static constexpr std::uint8_t kSpeed = 0x02;
    static constexpr std::uint8_t kAcceleration = 0x04;
    static constexpr std::uint8_t kTimer = 0x08;
    static constexpr std::uint8_t kReverse = 0x10;
    static constexpr std::uint8_t kStartNow = 0x80;

    std::uint8_t control = 0;
    std::int32_t position = 0;
    std::uint8_t speed = 0;
    std::uint8_t accelerationTime = 1;  ///< units of 0.25 ms
    std::uint16_t timerCount = 1;
    std::uint8_t nearestSpeed = 0;  ///< speed from which ramps start after `timerCount`
    bool isLoaded = false;

    [[nodiscard]] bool has(std::uint8_t bit) const { return (control & bit) != 0; }
};

/// The mode that the loaded parameters lead to from mode `from` (DS-S 5.1, Table 4); nothing when the table
/// forbids it, or when a parameter was loaded that must not be, or one that must be was not.
[[nodiscard]] std::optional<StepperMode> goalMode(StepperMode from, std::uint8_t control);

}  // namespace nmc::sim
