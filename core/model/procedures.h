// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "model/intent.h"
#include "model/procedure.h"

namespace nmc {

/// The procedure that an intent asks for; null when plan() does it in one operation.
[[nodiscard]] std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module);

}  // namespace nmc
