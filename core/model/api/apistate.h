// SPDX-License-Identifier: MIT
#pragma once

#include "model/api/apimethods.h"
#include "model/module/linkstate.h"
#include "model/settings/machine.h"

/// What `state` returns (docs/api.md). Values are in the units that the user has chosen for the axis; what is
/// not known is null. Pure.
namespace nmc::api {

/// The chain and its modules.
[[nodiscard]] Json stateOf(const LinkState& link, const Machine& machine);
/// One module of it.
[[nodiscard]] Json stateOf(const ModuleState& module, const AxisSettings& axis);
/// The type of a module as the state has it.
[[nodiscard]] std::string nameOf(ModuleType type);

}  // namespace nmc::api
