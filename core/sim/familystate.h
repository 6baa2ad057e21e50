// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "sim/snapshot.h"

namespace nmc::sim {

/// The parts of `state` that describe a PIC-I/O, and what CMC and SC have beyond every other PIC-SERVO.
[[nodiscard]] nlohmann::ordered_json ioJson(const IoSnapshot& io);
[[nodiscard]] nlohmann::ordered_json laterServoJson(const ModuleIdentity& module, const ServoSnapshot& servo);

}  // namespace nmc::sim
