// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "tests/bus/steps.h"
#include "tests/sessions/rig.h"

/// What an operator requests of one module, whichever chip it has; `index` is that of the engine.
namespace nmc::test {

/// Duration of a fault that outlasts whatever is tried in the meantime.
inline constexpr Duration kForLong = std::chrono::seconds(60);

/// Sets the gains, or the parameters without which a stepper does not move; then switches the motor on.
[[nodiscard]] std::vector<bus::Order> switchOn(std::uint8_t index, ModuleIdentity identity);
[[nodiscard]] std::vector<bus::Order> switchOff(std::uint8_t index, ModuleIdentity identity);
/// A move that takes its time; `far` is 1..256.
[[nodiscard]] std::vector<bus::Order> moveFar(std::uint8_t index, ModuleIdentity identity, unsigned far);
/// Only loads such a move.
[[nodiscard]] bus::Order loadFar(std::uint8_t index, ModuleIdentity identity, unsigned far);
/// A motion without an end; `speed` is 1..256.
[[nodiscard]] std::vector<bus::Order> runOn(std::uint8_t index, ModuleIdentity identity, unsigned speed);
[[nodiscard]] bus::HoldToMove holdOn(std::uint8_t index, ModuleIdentity identity, unsigned speed);

/// Connects, gives all modules what they need, and sets `moving` of them in motion. Returns false if that
/// fails.
[[nodiscard]] bool setRunning(Rig& rig, std::size_t moving);
/// Runs until the search has ended; returns true if a chain was found.
[[nodiscard]] bool connectAndWait(Rig& rig);

}  // namespace nmc::test
