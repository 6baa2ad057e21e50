// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "module/modulecommand.h"

namespace nmc {

/// How a motor is brought to rest.
enum class StopManner : std::uint8_t {
    Abruptly,
    Smoothly,
    Off,  ///< servo or amplifier off, for example for a motor that runs the wrong way and would continue
};

/// The manner that ends more: off more than an abrupt stop, and that more than a smooth one.
[[nodiscard]] StopManner firmer(StopManner one, StopManner other);

/// The Stop Motor of a motor chip. `amplifier`: AMP_EN is set, unless the motor is switched off.
[[nodiscard]] ModuleCommand stopMotor(ModuleType chip, StopManner manner, bool amplifier);
/// How the motor will come to rest if the command is only a stop; empty otherwise. Stop Here counts as an
/// abrupt stop.
[[nodiscard]] std::optional<StopManner> stopManner(const ModuleCommand& command);

/// Sets what the chip does when home is found; a SetHoming of either motor chip.
template <typename SetHoming>
[[nodiscard]] SetHoming stoppingBy(StopManner manner, SetHoming homing) {
    homing.motorOff = manner == StopManner::Off;
    homing.stopAbruptly = manner == StopManner::Abruptly;
    homing.stopSmoothly = manner == StopManner::Smoothly;
    return homing;
}

}  // namespace nmc
