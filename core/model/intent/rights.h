// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/intent/intent.h"

namespace nmc {

/// Defines what operator mode leaves to an operator, and to what the panel does by itself; nothing else does.
/// Empty rights mean everything is allowed. Pure; any thread.

[[nodiscard]] bool allows(const OperatorRights& rights, IntentKind kind);

/// Why the stored machine cannot be edited: axes, points, sequences, groups, the expected chain.
[[nodiscard]] std::optional<Refusal> whyNotEdited(const std::optional<OperatorRights>& rights);

/// Why the settings of its axis cannot be edited: also those for another type of module.
[[nodiscard]] std::optional<Refusal> whyNotEdited(const ModuleState& module);

/// The module as points and sequences see it: if these are left to an operator, so is everything they consist
/// of; if not, none of it is.
[[nodiscard]] ModuleState asOfSequence(ModuleState module);
[[nodiscard]] std::vector<ModuleState> asOfSequence(std::vector<ModuleState> modules);

/// The module as the panel sees it for its own actions: arming a limit stop, or finishing what was begun.
[[nodiscard]] ModuleState asOfPanel(ModuleState module);

}  // namespace nmc
