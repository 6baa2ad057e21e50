// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"

namespace nmc {

/// plan() and whyNot() for a PIC-I/O. Pure.
[[nodiscard]] Plan planIo(const Intent& intent, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotIo(IntentKind kind, const ModuleState& module);

}  // namespace nmc
