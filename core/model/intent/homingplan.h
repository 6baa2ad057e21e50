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

/// Slow, and over in a minute; what a user begins with.
[[nodiscard]] HomingRecipe firstRecipe(const ModuleIdentity& identity);

/// What is left of a recipe on this chip: a position error switches the servo off by itself, zero needs home
/// to be gone to, and the other chip's conditions do not count.
[[nodiscard]] HomingRecipe effective(HomingRecipe recipe, const ModuleIdentity& identity);

}  // namespace nmc
