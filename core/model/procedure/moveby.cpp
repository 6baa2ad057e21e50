// SPDX-License-Identifier: MIT
#include "model/procedure/moveby.h"

#include <algorithm>

#include "model/intent/backlash.h"

namespace nmc {

MoveByRun::MoveByRun(const intent::MoveBy& wanted, const ModuleState& module)
    : GoalMoves(ProcedureKind::MoveBy, module), m_moves(wanted.moves), m_pace(wanted.pace) {
    m_report.rounds = std::max(m_moves.rounds, 1U);
}

Intent MoveByRun::moveTo(std::int32_t goal) const {
    return intent::Move{nmc::moveTo(goal, m_pace)};
}

MoveByRun::Next MoveByRun::standing(const ModuleState& module, TimePoint now) {
    if (m_report.stage == ProcedureStage::TakingUpBacklash)
        return go(ProcedureStage::Moving, *m_goal, module);
    if (m_report.stage == ProcedureStage::Moving) {
        if (m_made >= m_report.rounds * (m_moves.backAndForth ? 2 : 1))
            return finish();
        m_report.stage = ProcedureStage::Pausing;
        m_pausedAt = now;
        return Wait{};
    }
    const bool pausing = m_report.stage == ProcedureStage::Pausing;
    if (pausing && toSeconds(now - m_pausedAt) < m_moves.pause)
        return Wait{};
    return nextMove(module);
}

MoveByRun::Next MoveByRun::nextMove(const ModuleState& module) {
    if (!module.latest->position)
        return fail(ProcedureFailure::Refused);
    if (!m_goal)
        m_goal = module.goal().value_or(*module.latest->position);
    const bool back = m_moves.backAndForth && m_made % 2 == 1;
    const std::int64_t from = *m_goal;
    const std::int64_t goal = from + (back ? -std::int64_t{m_moves.counts} : m_moves.counts);
    m_goal = goal;
    ++m_made;
    m_report.round = m_moves.backAndForth ? (m_made + 1) / 2 : m_made;
    if (const auto turn = turningPoint(from, goal, module))
        return go(ProcedureStage::TakingUpBacklash, *turn, module);
    return go(ProcedureStage::Moving, goal, module);
}

}  // namespace nmc
