// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/intent/travel.h"
#include "model/settings/axisscale.h"
#include "widgets/common/workwords.h"

/// Travel and speed limits (model/intent/travel.h), in words.
namespace nmc::texts {

/// Why a motion is refused, with the limit or the speed that prevents it.
[[nodiscard]] QString travelProblem(const TravelProblem& problem, const Zero& zero, const AxisScale& scale);
[[nodiscard]] QString travelProblem(const TravelProblem& problem, const ModuleState& module,
                                    const AxisScale& scale);
/// Why the range of a velocity ends where it does; empty if the module determines it.
[[nodiscard]] QString fastestReason(const TravelSettings& travel);
/// Why the range of the jog speed ends where it does.
[[nodiscard]] QString jogReason();
/// Why an intent is refused: as travelProblem() says if a travel or speed limit is the reason, otherwise one
/// sentence.
[[nodiscard]] QString refusal(Refusal refusal, const Intent& intent, const ModuleState& module,
                              const AxisScale& scale);
/// A shape, then words: whether the limits are in force, or why not.
[[nodiscard]] QString travelState(const ModuleState& module, const AxisScale& scale);
/// For the head of a panel: says that the axis is at a limit or outside, or that limits are set but not in
/// force; otherwise empty.
[[nodiscard]] QString travelSign(const ModuleState& module, const AxisScale& scale);
/// The question before the user confirms the position.
[[nodiscard]] QString declareQuestion(const ModuleState& module, const AxisScale& scale);

}  // namespace nmc::texts
