// SPDX-License-Identifier: MIT
#include "model/procedures.h"

#include "model/changemotion.h"
#include "model/homingplan.h"
#include "model/homingrun.h"
#include "model/stepby.h"
#include "model/stepresponse.h"

namespace nmc {

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    if (const auto* home = std::get_if<intent::Home>(&intent))
        return whyNotHome(home->recipe, module) ? nullptr : std::make_unique<HomingRun>(home->recipe, module);
    if (const auto* stepBy = std::get_if<intent::StepBy>(&intent))
        return plan(intent, module) ? std::make_unique<StepByRun>(*stepBy, module) : nullptr;
    if (const auto* step = std::get_if<intent::StepResponse>(&intent))
        return plan(intent, module) ? std::make_unique<StepResponseRun>(*step, module) : nullptr;
    if (const auto* change = std::get_if<stepintent::ChangeMotion>(&intent))
        return std::make_unique<ChangeMotion>(module.info.index, change->motion);
    return nullptr;
}

}  // namespace nmc
