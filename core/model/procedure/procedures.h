// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Creates the procedure that an intent requires; null when it requires none, or when it is not possible now,
/// for which plan() gives the reason.
[[nodiscard]] std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module);

/// Reduces the orders of a procedure after another party's stop to those that neither move anything nor
/// switch anything on.
void keepWhatIsHarmless(std::vector<bus::Order>& orders);

/// Splits the orders that end a procedure into the stops with which they begin and the rest: a stop that is
/// an operation by itself does not wait for what is queued (docs/link.md 2.6). Returns the stops, and leaves
/// the rest; returns nothing if there is no rest.
[[nodiscard]] std::vector<bus::Order> takeStops(std::vector<bus::Order>& orders);

}  // namespace nmc
