// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// The steps from a servo that was just found to one that moves; each requires the previous ones.
enum class FirstStep : std::uint8_t { FillInGains, ApplyGains, Enable, Jog };

/// The next step: the first whose outcome is not visible in `module` and `axis`. Empty for a servo that has
/// gains and an acceleration, which every motion sets, and for other modules. Pure; any thread.
[[nodiscard]] std::optional<FirstStep> nextFirstStep(const ModuleState& module, const AxisSettings& axis);

}  // namespace nmc
