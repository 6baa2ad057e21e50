// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// The procedure that an intent asks for; null when it is none, or is not possible now, which plan() tells.
[[nodiscard]] std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module);

}  // namespace nmc
