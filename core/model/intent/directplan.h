// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"

namespace nmc {

/// Why a command cannot be sent as it is: the preconditions of the panel's own controls apply, and where
/// there are none, what the data sheets and the bus's gate (bus/gate.h) allow. Pure.
[[nodiscard]] std::optional<Refusal> whyNotDirect(const ModuleCommand& command, const ModuleState& module);

}  // namespace nmc
