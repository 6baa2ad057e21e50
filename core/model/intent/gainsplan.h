// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"

/// What gains need before they can be sent or tried. Pure.
namespace nmc {

/// As this version takes them: DB came with version 4 (DS-V 5.2).
[[nodiscard]] servo::SetGain gainsFor(const ModuleState& module, servo::SetGain gains);

/// A try needs gains to go back to, and a motor that holds still, so that whatever moves is their doing.
[[nodiscard]] std::optional<Refusal> whyNot(const intent::TryGains& wanted, const ModuleState& module);

}  // namespace nmc
