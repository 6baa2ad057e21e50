// SPDX-License-Identifier: MIT
#include "model/procedure/procedures.h"

#include "model/intent/homingplan.h"
#include "model/intent/stepplan.h"
#include "model/procedure/changemotion.h"
#include "model/procedure/directioncheck.h"
#include "model/procedure/homingrun.h"
#include "model/procedure/stepby.h"
#include "model/procedure/stepresponse.h"

namespace nmc {

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    if (const auto* home = std::get_if<intent::Home>(&intent))
        return whyNotHome(home->recipe, module)
                   ? nullptr
                   : std::make_unique<HomingRun>(home->recipe, home->tolerance, module);
    if (const auto* stepBy = std::get_if<intent::StepBy>(&intent))
        return plan(intent, module) ? std::make_unique<StepByRun>(*stepBy, module) : nullptr;
    if (const auto* step = std::get_if<intent::StepResponse>(&intent))
        return plan(intent, module) ? std::make_unique<StepResponseRun>(*step, module) : nullptr;
    if (const auto* check = std::get_if<intent::CheckDirection>(&intent))
        return plan(intent, module) ? std::make_unique<DirectionCheck>(*check, module) : nullptr;
    if (const auto* change = std::get_if<stepintent::ChangeMotion>(&intent))
        return whyNotFromStandstill(change->motion, module)
                   ? nullptr
                   : std::make_unique<ChangeMotion>(module.info.index, change->motion);
    return nullptr;
}

}  // namespace nmc
