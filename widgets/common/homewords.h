// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/module/modulestate.h"
#include "model/settings/axisscale.h"

/// What is known about the home of an axis (model/module/homefact.h), in words.
namespace nmc::texts {

/// "Home: 512 counts", "Home: unknown". `zero`: the work offset in use, from which it is counted.
[[nodiscard]] QString home(const std::optional<HomeFact::Place>& place, const std::optional<WorkZero>& zero,
                           const AxisScale& scale);
/// Where home is, since when, and how it was determined; or what would make it known. `seen`: time of the
/// last status.
[[nodiscard]] QString homeMeaning(const std::optional<HomeFact::Place>& place,
                                  const std::optional<WorkZero>& zero, TimePoint seen,
                                  const AxisScale& scale);
/// What "Zero here" does, and what is lost.
[[nodiscard]] QString zeroMeaning(const ModuleState& module, const AxisScale& scale);
/// What the chip's own home register contains.
[[nodiscard]] QString homeRegisterMeaning();

}  // namespace nmc::texts
