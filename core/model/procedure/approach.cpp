// SPDX-License-Identifier: MIT
#include "model/procedure/approach.h"

#include <utility>

#include "model/intent/travel.h"

namespace nmc {

Approach::Approach(const intent::GoTo& wanted, std::int32_t turn, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::Approach), m_wanted(wanted), m_turn(turn) {
    m_mayRun = true;
}

Approach::Next Approach::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    if (!module.servoOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Preparing)
        return go(ProcedureStage::TakingUpBacklash, m_turn, module);
    if (!std::exchange(m_started, true)) {
        m_startedAt = now;
        m_standstill.reset();
    }
    // Its goal is not ours any more: something else moves or has stopped it.
    if (module.goal() != m_goal) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    return m_report.stage == ProcedureStage::Moving
               ? finish()
               : go(ProcedureStage::Moving, m_wanted.position.value(), module);
}

Approach::Next Approach::go(ProcedureStage stage, std::int32_t goal, const ModuleState& module) {
    const auto steps = plan(intent::GoTo{Counts(goal), m_wanted.velocity, m_wanted.acceleration}, module);
    if (!steps)
        return fail(travelProblem(m_wanted, module) ? ProcedureFailure::SoftLimit
                                                    : ProcedureFailure::Refused);
    m_report.stage = stage;
    m_goal = goal;
    m_started = false;
    return send(*steps);
}

std::vector<bus::Step> Approach::lastWord(const ModuleState& module) const {
    // To a servo that is off the stop would be what switches it on.
    if (!m_mayRun || !module.servoOn())
        return {};
    return {{module.info.index, ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})}};
}

}  // namespace nmc
