// SPDX-License-Identifier: MIT
#include "model/procedure/approach.h"

#include "base/overloaded.h"
#include "model/intent/stepperplan.h"

namespace nmc {

namespace {

[[nodiscard]] std::int32_t endOf(const Approach::Wanted& wanted, const ModuleState& module) {
    if (const auto* goTo = std::get_if<intent::GoTo>(&wanted))
        return goTo->position.value();
    return static_cast<std::int32_t>(
        goalOf(std::get<stepperintent::Move>(wanted).motion, module).value_or(0));
}

}  // namespace

Approach::Approach(const Wanted& wanted, std::int32_t turn, const ModuleState& module)
    : GoalMoves(ProcedureKind::Approach, module),
      m_wanted(wanted),
      m_end(endOf(wanted, module)),
      m_turn(turn) {}

Approach::Next Approach::standing(const ModuleState& module, TimePoint /*now*/) {
    if (m_report.stage == ProcedureStage::Preparing)
        return go(ProcedureStage::TakingUpBacklash, m_turn, module);
    return m_report.stage == ProcedureStage::Moving ? finish() : go(ProcedureStage::Moving, m_end, module);
}

Intent Approach::moveTo(std::int32_t goal) const {
    return std::visit(Overloaded{
                          [goal](intent::GoTo move) -> Intent {
                              move.position = Counts(goal);
                              return move;
                          },
                          [goal](stepperintent::Move move) -> Intent {
                              std::visit(
                                  [goal](auto& motion) {
                                      if constexpr (requires { motion.relative; }) {
                                          motion.position = goal;
                                          motion.relative = false;
                                      }
                                  },
                                  move.motion);
                              return move;
                          },
                      },
                      m_wanted);
}

}  // namespace nmc
