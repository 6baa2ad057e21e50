// SPDX-License-Identifier: MIT
#include "model/procedure/approach.h"

#include <utility>

#include "base/overloaded.h"
#include "model/intent/stepplan.h"
#include "model/intent/travel.h"

namespace nmc {

namespace {

[[nodiscard]] std::int32_t endOf(const Approach::Wanted& wanted, const ModuleState& module) {
    if (const auto* goTo = std::get_if<intent::GoTo>(&wanted))
        return goTo->position.value();
    return static_cast<std::int32_t>(goalOf(std::get<stepintent::Move>(wanted).motion, module).value_or(0));
}

}  // namespace

Approach::Approach(const Wanted& wanted, std::int32_t turn, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::Approach),
      m_wanted(wanted),
      m_end(endOf(wanted, module)),
      m_turn(turn) {
    m_mayRun = true;
}

Approach::Next Approach::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    if (!module.driveOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Preparing)
        return go(ProcedureStage::TakingUpBacklash, m_turn, module);
    if (!std::exchange(m_started, true)) {
        m_startedAt = now;
        m_standstill.reset();
    }
    // Its goal is not ours any more: something else moves or has stopped it.
    if ((module.isStepper() ? module.stepper.goal() : module.goal()) != m_goal) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    if (module.isStepper() && *module.latest->position != m_goal)
        return fail(ProcedureFailure::StoppedShort);
    return m_report.stage == ProcedureStage::Moving ? finish() : go(ProcedureStage::Moving, m_end, module);
}

Approach::Next Approach::go(ProcedureStage stage, std::int32_t goal, const ModuleState& module) {
    const Intent next = moveTo(goal);
    const auto steps = plan(next, module);
    if (!steps)
        return fail(travelProblem(next, module) ? ProcedureFailure::SoftLimit : ProcedureFailure::Refused);
    m_report.stage = stage;
    m_goal = goal;
    m_started = false;
    return send(*steps);
}

Intent Approach::moveTo(std::int32_t goal) const {
    return std::visit(Overloaded{
                          [goal](intent::GoTo move) -> Intent {
                              move.position = Counts(goal);
                              return move;
                          },
                          [goal](stepintent::Move move) -> Intent {
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

std::vector<bus::Step> Approach::lastWord(const ModuleState& module) const {
    // To a servo that is off the stop would be what switches it on.
    if (!m_mayRun || !module.driveOn())
        return {};
    return {smoothStop(module)};
}

}  // namespace nmc
