// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sim/steppertimer.h"

namespace nmc::sim {

/// The data of Set Parameters (DS-S 5.1).
struct StepperParameters {
    static constexpr std::uint8_t kSpeedMode = 0x03;
    static constexpr std::uint8_t kIgnoreLimits = 0x04;
    static constexpr std::uint8_t kIgnoreEstop = 0x08;
    static constexpr std::uint8_t kMotorOff = 0x10;

    std::uint8_t mode = 0;
    std::uint8_t minimumSpeed = 1;
    std::uint8_t runningCurrent = 0;
    std::uint8_t holdingCurrent = 0;
    std::uint8_t thermalLimit = 0;

    [[nodiscard]] bool has(std::uint8_t bit) const { return (mode & bit) != 0; }
    [[nodiscard]] SpeedMode speedMode() const { return static_cast<SpeedMode>(mode & kSpeedMode); }
};

}  // namespace nmc::sim
