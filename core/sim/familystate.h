// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "sim/snapshot.h"

namespace nmc::sim {

/// What `state` tells of a PIC-I/O, and of CMC and SC beyond what every PIC-SERVO has.
[[nodiscard]] nlohmann::ordered_json ioJson(const IoSnapshot& io);
[[nodiscard]] nlohmann::ordered_json laterServoJson(const ModuleIdentity& module, const ServoSnapshot& servo);

}  // namespace nmc::sim
