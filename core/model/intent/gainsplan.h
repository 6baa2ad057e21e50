// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"

/// Preconditions for sending and trying gains. Pure.
namespace nmc {

/// Reduces the gains to those that the module's version has: DB came with version 4 (DS-V 5.2).
[[nodiscard]] servo::SetGain gainsFor(const ModuleState& module, servo::SetGain gains);

/// A trial needs gains to go back to, and a motor at standstill, so that any motion is due to the gains.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::TryGains& wanted, const ModuleState& module);

}  // namespace nmc
