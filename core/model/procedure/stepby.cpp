// SPDX-License-Identifier: MIT
#include "model/procedure/stepby.h"

#include <algorithm>
#include <utility>

namespace nmc {

StepByRun::StepByRun(const intent::StepBy& wanted, const ModuleState& module)
    : Procedure(module.info.index, ProcedureKind::StepBy), m_wanted(wanted) {
    m_report.rounds = std::max(wanted.rounds, 1U);
    m_mayRun = true;
}

StepByRun::Next StepByRun::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    if (!module.servoOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Moving)
        return moving(module, now);
    const bool pausing = m_report.stage == ProcedureStage::Pausing;
    if (pausing && toSeconds(now - m_pausedAt) < m_wanted.pause)
        return Wait{};
    return move(module);
}

StepByRun::Next StepByRun::move(const ModuleState& module) {
    if (!module.latest->position)
        return fail(ProcedureFailure::Refused);
    if (!m_goal)
        m_goal = module.goal().value_or(*module.latest->position);
    const bool back = m_wanted.backAndForth && m_moves % 2 == 1;
    const std::int64_t goal = *m_goal + (back ? -std::int64_t{m_wanted.counts} : m_wanted.counts);
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return fail(ProcedureFailure::TravelLimit);
    m_goal = goal;
    ++m_moves;
    m_report.round = m_wanted.backAndForth ? (m_moves + 1) / 2 : m_moves;
    m_report.stage = ProcedureStage::Moving;
    m_started = false;
    servo::LoadTrajectory load;
    load.position = Counts(static_cast<std::int32_t>(goal));
    load.velocity = m_wanted.velocity;
    load.acceleration = m_wanted.acceleration;
    return send({{module.info.index, ServoCommand(load)}, {module.info.index, ServoCommand(StartMotion{})}});
}

StepByRun::Next StepByRun::moving(const ModuleState& module, TimePoint now) {
    if (!std::exchange(m_started, true)) {
        m_startedAt = now;
        m_standstill.reset();
    }
    // Its goal is not ours any more: something else moves or has stopped it.
    if (module.goal() != static_cast<std::int32_t>(*m_goal)) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    const unsigned moves = m_report.rounds * (m_wanted.backAndForth ? 2 : 1);
    if (m_moves >= moves)
        return finish();
    m_report.stage = ProcedureStage::Pausing;
    m_pausedAt = now;
    return Wait{};
}

std::vector<bus::Step> StepByRun::lastWord(const ModuleState& module) const {
    // To a servo that is off the stop would be what switches it on.
    if (!m_mayRun || !module.servoOn())
        return {};
    return {{module.info.index, ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})}};
}

}  // namespace nmc
