// SPDX-License-Identifier: MIT
#include "model/procedure/repeatabilityrun.h"

#include <algorithm>
#include <utility>

namespace nmc {

namespace {

[[nodiscard]] HomingRecipe withoutEnd(HomingRecipe recipe) {
    recipe.stop = HomingRecipe::Stop::Smoothly;
    recipe.goToHome = recipe.makeZero = false;
    return recipe;
}

}  // namespace

RepeatabilityRun::RepeatabilityRun(const intent::MeasureRepeatability& wanted, const ModuleState& module)
    : HomingRun(ProcedureKind::Repeatability, withoutEnd(wanted.recipe), 0, module),
      m_reverse(wanted.recipe.reverse) {
    m_report.rounds = wanted.times;
    m_report.round = 1;
    m_report.edges.index = wanted.recipe.onIndex;
    // DS-V does not say whether a PIC-SERVO reads its inputs once per servo tick or in each tick of 0.512 ms,
    // and DS-S nothing at all: of a PIC-STEP, whose velocity is per second, the latter is assumed.
    m_report.edges.perReading = wanted.recipe.velocity / (module.isServo() ? 1.0 : ticksPerSecond(1));
    if (module.isServo() && module.gains)
        m_report.edges.readings = std::max(module.gains->sr, std::uint8_t{1});
    if (const auto seen = HomingChip(module).look(module); seen && !wanted.recipe.onIndex && anyActive(*seen))
        turnRound();
}

/// The index is a pulse: it is approached from beside it.
bool RepeatabilityRun::leavesFirst(const HomingLook& seen) const {
    return m_report.edges.index && anyActive(seen);
}

RepeatabilityRun::Next RepeatabilityRun::found(const HomingLook& seen, TimePoint now) {
    EdgeCaptures& edges = m_report.edges;
    const bool closes = recipe().reverse == m_reverse;
    if (!edges.index && anyActive(seen) != closes)
        return fail(ProcedureFailure::Bounced);
    (recipe().reverse ? edges.reverse : edges.forward).push_back(*std::exchange(m_report.home, {}));
    const std::size_t done = std::min(edges.forward.size(), edges.reverse.size());
    if (done == m_report.rounds)
        return disarm();
    m_report.round = static_cast<unsigned>(done) + 1;
    if (!seen.on)  // a stepper that its limit switches off
        return fail(ProcedureFailure::WentOff);
    turnRound();
    return beginSearch(seen, now);
}

}  // namespace nmc
