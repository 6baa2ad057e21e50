// SPDX-License-Identifier: MIT
#include "model/module/holding.h"

#include <cstdlib>

#include "model/module/modulestate.h"

namespace nmc {

std::optional<Holding> holdingOf(const ModuleState& module) {
    constexpr std::int64_t kHeldWithin = 2;
    const Activity activity = module.activity();
    const auto goal = module.goal();
    if (!module.isServo() || (activity != Activity::Holding && activity != Activity::Limited) || !goal ||
        !module.latest->position || module.latestTime - module.motionCommandedAt < SwingWatch::kCalm)
        return std::nullopt;
    Holding holding{std::int64_t{*goal} - *module.latest->position, false};
    if (std::abs(holding.off) <= kHeldWithin)
        return std::nullopt;
    if (module.gains) {
        const servo::SetGain& gains = *module.gains;
        const std::int64_t asked = gains.kp * std::abs(holding.off) + std::int64_t{gains.ki} * gains.il;
        holding.atLimit = asked >= std::int64_t{gains.ol} * 256;
    }
    return holding;
}

}  // namespace nmc
