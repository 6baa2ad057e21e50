// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/intent/intent.h"

namespace nmc {

/// What operator mode leaves to an operator, and to what the panel does by itself, is said here and nowhere
/// else; empty rights are everything. Pure; any thread.

[[nodiscard]] bool allows(const OperatorRights& rights, IntentKind kind);

/// Why what is kept of the machine cannot be changed: axes, points, sequences, groups, what is expected of
/// the chain.
[[nodiscard]] std::optional<Refusal> whyNotEdited(const std::optional<OperatorRights>& rights);

/// As points and sequences find it: where those are left to an operator, what they consist of is, too; where
/// they are not, nothing of it is.
[[nodiscard]] ModuleState asOfSequence(ModuleState module);
[[nodiscard]] std::vector<ModuleState> asOfSequence(std::vector<ModuleState> modules);

/// As the panel finds it for what nobody asks for: arming a limit stop, going through with what was begun.
[[nodiscard]] ModuleState asOfPanel(ModuleState module);

}  // namespace nmc
