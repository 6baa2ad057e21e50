// SPDX-License-Identifier: MIT
#include "model/procedure/approach.h"

namespace nmc {

Approach::Approach(const MotionSpec& motion, std::int64_t turn, const ModuleState& module)
    : GoalMoves(ProcedureKind::Approach, module),
      m_motion(motion),
      m_end(static_cast<std::int32_t>(goalOf(motion, *module.latest->position).value_or(0))),
      m_turn(turn) {}

Approach::Next Approach::standing(const ModuleState& module, TimePoint /*now*/) {
    if (m_report.stage == ProcedureStage::Preparing)
        return go(ProcedureStage::TakingUpBacklash, m_turn, module);
    return m_report.stage == ProcedureStage::Moving ? finish() : go(ProcedureStage::Moving, m_end, module);
}

Intent Approach::moveTo(std::int32_t goal) const {
    return intent::Move{endingAt(goal, m_motion)};
}

}  // namespace nmc
