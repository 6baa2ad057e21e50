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
/// standstill, so that the next motion is watched; it is armed again after it has tripped. A condition that
/// cannot be armed now is left out: a switch on which the motor stands and which it must be able to leave, a
/// limit pin that is an output, or the current while CL is 0 or unknown. Empty if the rest is armed already
/// or is nothing, or if the chip cannot be sent it.
[[nodiscard]] std::optional<intent::ArmLimitStop> limitStopDue(const ModuleState& module);

/// A slow search that ends within a minute; the default for a user to start from.
[[nodiscard]] HomingRecipe firstRecipe(const ModuleIdentity& identity);

/// Reduces a recipe to what applies to this chip: a position error switches the servo off by itself, setting
/// zero requires going to home, and conditions of the other chip are dropped.
[[nodiscard]] HomingRecipe effective(HomingRecipe recipe, const ModuleIdentity& identity);

}  // namespace nmc
