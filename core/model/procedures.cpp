// SPDX-License-Identifier: MIT
#include "model/procedures.h"

#include "model/homingplan.h"
#include "model/homingrun.h"
#include "model/stepby.h"

namespace nmc {

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    if (const auto* home = std::get_if<intent::Home>(&intent))
        return whyNotHome(home->recipe, module) ? nullptr : std::make_unique<HomingRun>(home->recipe, module);
    if (const auto* stepBy = std::get_if<intent::StepBy>(&intent))
        return plan(intent, module) ? std::make_unique<StepByRun>(*stepBy, module) : nullptr;
    return nullptr;
}

}  // namespace nmc
