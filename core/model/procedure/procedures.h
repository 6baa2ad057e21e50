// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// The procedure that an intent asks for; null when it is none, or is not possible now, which plan() tells.
[[nodiscard]] std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module);

/// Of what a procedure sends after a stop by somebody else: what neither moves nor switches anything on.
void keepWhatIsHarmless(std::vector<bus::Order>& orders);

}  // namespace nmc
