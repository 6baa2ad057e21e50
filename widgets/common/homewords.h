// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/module/modulestate.h"
#include "model/settings/axisscale.h"

/// What is known of an axis' home (model/module/homefact.h), in words.
namespace nmc::texts {

/// "Home: 512 counts", "Home: unknown"
[[nodiscard]] QString home(const std::optional<HomeFact::Place>& place, const AxisScale& scale);
/// Where, since when and by what; or what would make it known. `seen`: when the module has spoken last.
[[nodiscard]] QString homeMeaning(const std::optional<HomeFact::Place>& place, TimePoint seen,
                                  const AxisScale& scale);
/// What "Zero here" does, and what is lost by it.
[[nodiscard]] QString zeroMeaning(const ModuleState& module, const AxisScale& scale);
/// What the chip's own register is, beside all that.
[[nodiscard]] QString homeRegisterMeaning();

}  // namespace nmc::texts
