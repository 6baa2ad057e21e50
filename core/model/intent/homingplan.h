// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"

/// What a home search and an armed limit stop need before they can be asked for. Pure.
namespace nmc {

/// Whatever the recipe.
[[nodiscard]] std::optional<Refusal> whyNotHome(const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotHome(const HomingRecipe& recipe, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotArm(const intent::ArmLimitStop& arm, const ModuleState& module);
[[nodiscard]] servo::SetHoming limitStop(const intent::ArmLimitStop& arm);

/// An axis that wants a limit stop for each of its motions (LimitStopSettings): what has to be armed now, at
/// standstill, so that the next motion is watched; again after it has tripped. Nothing: it is armed, need not
/// be, or cannot be, as while the motor stands in a switch, which it must be able to leave.
[[nodiscard]] std::optional<intent::ArmLimitStop> limitStopDue(const ModuleState& module);

/// Slow, and over in a minute; what a user begins with.
[[nodiscard]] HomingRecipe firstRecipe(const ModuleIdentity& identity);

/// What is left of a recipe on this chip: a position error switches the servo off by itself, zero needs home
/// to be gone to, and the other chip's conditions do not count.
[[nodiscard]] HomingRecipe effective(HomingRecipe recipe, const ModuleIdentity& identity);

}  // namespace nmc
