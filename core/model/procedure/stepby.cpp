// SPDX-License-Identifier: MIT
#include "model/procedure/stepby.h"

#include <algorithm>
#include <utility>

namespace nmc {

StepByRun::StepByRun(const intent::StepBy& wanted, const ModuleState& module) : m_wanted(wanted) {
    m_report.module = module.info.index;
    m_report.kind = ProcedureKind::StepBy;
    m_report.rounds = std::max(wanted.rounds, 1U);
}

StepByRun::Next StepByRun::next(const ModuleState& module, TimePoint now) {
    if (m_inFlight)
        return Wait{};
    if (!m_end && module.silent)
        fail(ProcedureFailure::ModuleSilent);
    else if (!m_end && !module.servoOn())
        fail(ProcedureFailure::WentOff);
    if (m_end)
        return giveUp(module);
    if (m_report.stage == ProcedureStage::Moving) {
        Next next = moving(module, now);
        return m_end ? giveUp(module) : next;
    }
    const bool pausing = m_report.stage == ProcedureStage::Pausing;
    if (pausing && toSeconds(now - m_pausedAt) < m_wanted.pause)
        return Wait{};
    Next next = move(module);
    return m_end ? giveUp(module) : next;
}

StepByRun::Next StepByRun::move(const ModuleState& module) {
    if (!module.latest->position) {
        fail(ProcedureFailure::Refused);
        return Wait{};
    }
    if (!m_goal)
        m_goal = module.goal().value_or(*module.latest->position);
    const bool back = m_wanted.backAndForth && m_moves % 2 == 1;
    const std::int64_t goal = *m_goal + (back ? -std::int64_t{m_wanted.counts} : m_wanted.counts);
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max) {
        fail(ProcedureFailure::TravelLimit);
        return Wait{};
    }
    m_goal = goal;
    ++m_moves;
    m_report.round = m_wanted.backAndForth ? (m_moves + 1) / 2 : m_moves;
    m_report.stage = ProcedureStage::Moving;
    m_inFlight = true;
    m_started = false;
    servo::LoadTrajectory load;
    load.position = Counts(static_cast<std::int32_t>(goal));
    load.velocity = m_wanted.velocity;
    load.acceleration = m_wanted.acceleration;
    return Send{{{module.info.index, ServoCommand(load)}, {module.info.index, ServoCommand(StartMotion{})}}};
}

StepByRun::Next StepByRun::moving(const ModuleState& module, TimePoint now) {
    if (!std::exchange(m_started, true)) {
        m_startedAt = now;
        m_standstill.reset();
    }
    // Its goal is not ours any more: something else moves or has stopped it.
    if (module.goal() != static_cast<std::int32_t>(*m_goal)) {
        m_mayStop = false;
        m_end = ProcedureStage::Cancelled;
        return Wait{};
    }
    const bool fresh = module.latestTime > m_startedAt && module.latest->position;
    if (!fresh || !m_standstill.look(module.latestTime, *module.latest->position, module.moving()))
        return Wait{};
    const unsigned moves = m_report.rounds * (m_wanted.backAndForth ? 2 : 1);
    if (m_moves >= moves) {
        m_report.stage = ProcedureStage::Done;
        return End{};
    }
    m_report.stage = ProcedureStage::Pausing;
    m_pausedAt = now;
    return Wait{};
}

StepByRun::Next StepByRun::giveUp(const ModuleState& module) {
    // To a servo that is off the stop would be what switches it on.
    if (!std::exchange(m_stopSent, true) && m_mayStop && module.servoOn()) {
        m_inFlight = true;
        return Send{
            {{module.info.index, ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})}}};
    }
    m_report.stage = *m_end;
    return End{};
}

void StepByRun::fail(ProcedureFailure failure) {
    m_end = ProcedureStage::Failed;
    m_report.failure = failure;
}

void StepByRun::onFinished(bus::Outcome outcome) {
    m_inFlight = false;
    if (m_end || outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled) {
        m_end = ProcedureStage::Cancelled;
        m_mayStop = false;
    } else {
        fail(ProcedureFailure::Refused);
    }
}

void StepByRun::onLinkSuspect() {
    if (!m_end && !m_report.over())
        fail(ProcedureFailure::LinkSuspect);
}

void StepByRun::cancel() {
    if (!m_end && !m_report.over())
        m_end = ProcedureStage::Cancelled;
}

}  // namespace nmc
