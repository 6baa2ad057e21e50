// SPDX-License-Identifier: MIT
#include "model/procedure/stepby.h"

#include <algorithm>
#include <utility>

#include "model/intent/backlash.h"
#include "model/intent/travel.h"

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
    if (m_report.stage == ProcedureStage::Moving || m_report.stage == ProcedureStage::TakingUpBacklash)
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
    const std::int64_t from = *m_goal;
    const std::int64_t goal = from + (back ? -std::int64_t{m_wanted.counts} : m_wanted.counts);
    m_goal = goal;
    ++m_moves;
    m_report.round = m_wanted.backAndForth ? (m_moves + 1) / 2 : m_moves;
    const auto turn = turningPoint(from, goal, module);
    m_report.stage = turn ? ProcedureStage::TakingUpBacklash : ProcedureStage::Moving;
    return go(turn.value_or(goal), module);
}

StepByRun::Next StepByRun::go(std::int64_t goal, const ModuleState& module) {
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return fail(ProcedureFailure::TravelLimit);
    const intent::GoTo next{Counts(static_cast<std::int32_t>(goal)), m_wanted.velocity,
                            m_wanted.acceleration};
    if (travelProblem(next, module))
        return fail(ProcedureFailure::SoftLimit);
    m_heading = goal;
    m_started = false;
    servo::LoadTrajectory load;
    load.position = next.position;
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
    if (module.goal() != static_cast<std::int32_t>(m_heading)) {
        m_mayRun = false;
        cancel();
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    if (m_report.stage == ProcedureStage::TakingUpBacklash) {
        m_report.stage = ProcedureStage::Moving;
        return go(*m_goal, module);
    }
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
