// SPDX-License-Identifier: MIT
#include "model/intent/gainsplan.h"

namespace nmc {

servo::SetGain gainsFor(const ModuleState& module, servo::SetGain gains) {
    if (module.info.identity.version < servo::kDeadbandVersion)
        gains.db.reset();
    // Without this byte an SC takes 1, which is not what the user tuned.
    if (!isSc(module.info.identity))
        gains.sm.reset();
    else if (!gains.sm && module.gains)
        gains.sm = module.gains->sm;
    return gains;
}

std::optional<Refusal> whyNot(const intent::TryGains& /*wanted*/, const ModuleState& module) {
    if (const auto refusal = whyNot(IntentKind::ApplyGains, module))
        return refusal;
    return firstUnmet({{module.gains.has_value(), Refusal::GainsUnknown},
                       {module.position().has_value(), Refusal::PositionUnknown},
                       {module.servoOn(), Refusal::ServoOff},
                       {!module.moving(), Refusal::Moving}});
}

}  // namespace nmc
