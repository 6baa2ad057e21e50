// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/intent/travel.h"
#include "model/settings/axisscale.h"

/// The limits of travel and of speed (model/intent/travel.h), in words.
namespace nmc::texts {

/// Why that is refused, with the limit or the speed in its way.
[[nodiscard]] QString travelProblem(const TravelProblem& problem, const AxisScale& scale);
/// Why a velocity's range ends where it does; empty: the module counts no further.
[[nodiscard]] QString fastestReason(const TravelSettings& travel);
/// The same of the speed of a jog.
[[nodiscard]] QString jogReason();
/// Why an intent is refused: the same where that is why, one sentence otherwise.
[[nodiscard]] QString refusal(Refusal refusal, const Intent& intent, const ModuleState& module,
                              const AxisScale& scale);
/// Shape, then word: whether the limits are in force, or why not.
[[nodiscard]] QString travelState(const ModuleState& module, const AxisScale& scale);
/// For the head of a panel: that it is at a limit, or outside; empty within. And that set limits are not in
/// force.
[[nodiscard]] QString travelSign(const ModuleState& module, const AxisScale& scale);
/// What is asked before somebody declares the position right.
[[nodiscard]] QString declareQuestion(const ModuleState& module, const AxisScale& scale);

}  // namespace nmc::texts
