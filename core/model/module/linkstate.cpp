// SPDX-License-Identifier: MIT
#include "model/module/linkstate.h"

#include <algorithm>

namespace nmc {

void LinkState::take(const Machine& machine) {
    for (ModuleState& module : modules) {
        const AxisSettings& axis = machine.axis(module.info.index);
        module.unit = axis.unit.kind;
        module.travel = axis.travel;
        module.backlash = axis.backlash;
        module.limitStop = axis.limitStop;
    }
}

LinkState asShown(LinkState link) {
    const bool looking = link.phase == LinkPhase::Connecting && link.looking;
    for (ModuleState& module : link.modules) {
        module.lookedFor = looking;
        module.silent = module.silent || (link.phase != LinkPhase::Connected && !looking);
    }
    return link;
}

bool isMissing(const ModuleState& module) {
    return module.silent && !module.latest && !module.hasRestarted;
}

bool isLive(const LinkState& link, const ModuleState& module) {
    /// Three poll periods of a long chain at the slowest rate; below it nothing is called old.
    constexpr double kOldAfter = 0.5;  // s
    /// Of a module that is asked more rarely.
    constexpr double kPeriods = 3;
    if (link.phase != LinkPhase::Connected || module.silent || module.positionDoubtful())
        return false;
    if (!link.now || !module.latest)
        return true;
    const double rate = module.repliesPerSecond;
    const double oldAfter = rate > 0.0 ? std::max(kOldAfter, kPeriods / rate) : kOldAfter;
    return toSeconds(*link.now - module.latestTime) <= oldAfter;
}

}  // namespace nmc
