// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"

/// Preconditions of a home search, of measuring at what it finds, and of an armed limit stop. Pure.
namespace nmc {

/// Preconditions that are independent of the recipe.
[[nodiscard]] std::optional<Refusal> whyNotHome(const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotHome(const HomingRecipe& recipe, const ModuleState& module);
/// From each side.
inline constexpr unsigned kFewestApproaches = 2;
inline constexpr unsigned kMostApproaches = 100;
[[nodiscard]] std::optional<Refusal> whyNot(const intent::MeasureRepeatability& wanted,
                                            const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotArm(const intent::ArmLimitStop& arm, const ModuleState& module);
[[nodiscard]] servo::SetHoming limitStop(const intent::ArmLimitStop& arm);

/// For an axis that uses a limit stop for each of its motions (LimitStopSettings): what must be armed now, at
/// standstill, so that the next motion is watched; it is armed again after it has tripped. Empty if it is
/// armed already, is not needed, or cannot be armed, for example while the motor stands on a switch that it
/// must be able to leave.
[[nodiscard]] std::optional<intent::ArmLimitStop> limitStopDue(const ModuleState& module);

/// A slow search that ends within a minute; the default for a user to start from.
[[nodiscard]] HomingRecipe firstRecipe(const ModuleIdentity& identity);

/// Reduces a recipe to what applies to this chip: a position error switches the servo off by itself, setting
/// zero requires going to home, and conditions of the other chip are dropped.
[[nodiscard]] HomingRecipe effective(HomingRecipe recipe, const ModuleIdentity& identity);

}  // namespace nmc
