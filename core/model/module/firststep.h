// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// The way from a servo that was just found to one that moves; each needs those before it.
enum class FirstStep : std::uint8_t { FillInGains, ApplyGains, Enable, Jog };

/// The one that comes next: the first whose outcome can't be seen in `module` and `axis`. Empty: a servo that
/// has its gains and was given an acceleration, as every motion gives it one; and what is no servo. Pure; any
/// thread.
[[nodiscard]] std::optional<FirstStep> nextFirstStep(const ModuleState& module, const AxisSettings& axis);

}  // namespace nmc
