// SPDX-License-Identifier: MIT
#include "model/intent/backlash.h"

#include <cmath>

#include "model/intent/travel.h"

namespace nmc {

std::optional<std::int64_t> turningPoint(std::int64_t from, std::int64_t goal, const ModuleState& module) {
    const auto play = static_cast<std::int64_t>(std::llround(module.backlash.distance));
    if (play <= 0 || goal == from)
        return std::nullopt;
    const int side = module.backlash.fromAbove ? -1 : 1;  // the direction from which it must arrive
    const std::int64_t distance = (goal - from) * side;
    // A run that ended at its limit may have come from either side.
    const auto rests = module.goal();
    const bool takenUp = rests && module.goalReverse() == module.backlash.fromAbove &&
                         rests != travelEnd(module, false) && rests != travelEnd(module, true);
    if (distance >= play || (distance > 0 && takenUp))
        return std::nullopt;
    return goal - play * side;
}

std::optional<std::int64_t> turningPoint(std::int64_t goal, const ModuleState& module) {
    if (module.moving() || !module.latest || !module.latest->position)
        return std::nullopt;
    return turningPoint(module.goal().value_or(*module.latest->position), goal, module);
}

ModuleState withoutBacklash(ModuleState module) {
    module.backlash = {};
    return module;
}

}  // namespace nmc
