// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/snapshot.h"

namespace nmc::sim {

/// The answer to `state N` for module `number`, counted from 1.
[[nodiscard]] nlohmann::ordered_json stateJson(const ModuleSnapshot& module, unsigned number);

}  // namespace nmc::sim
