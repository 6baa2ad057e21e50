// SPDX-License-Identifier: MIT
#include "model/procedure/changemotion.h"

#include "model/intent/backlash.h"
#include "model/intent/stepperplan.h"

namespace nmc {

Procedure::Next ChangeMotion::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (m_report.stage == ProcedureStage::Preparing)
        return stop(module, now);
    return m_report.stage == ProcedureStage::Moving ? finish() : waitForStandstill(module, now);
}

Procedure::Next ChangeMotion::stop(const ModuleState& module, TimePoint now) {
    // A motion that is impossible from standstill too is no reason to stop a motor.
    if (whyNotFromStandstill(m_motion, module))
        return fail(ProcedureFailure::Refused);
    m_began = now;
    m_report.stage = ProcedureStage::Stopping;
    return send({smoothStop(module)});
}

/// Standstill must be confirmed by two statuses latched after the stop, or after the start of the move that
/// takes up the backlash.
Procedure::Next ChangeMotion::waitForStandstill(const ModuleState& module, TimePoint now) {
    if (!module.stepper.amplifierOn())
        return fail(ProcedureFailure::WentOff);
    if (m_report.stage == ProcedureStage::Stopping && now - m_began > kStopLimit)
        return fail(ProcedureFailure::TimeLimit);
    if (m_turn && passesNewLimit(*m_turn, module))
        return fail(ProcedureFailure::SoftLimit);
    if (!m_stoppedAt)
        m_stoppedAt = module.latestTime;
    if (module.latestTime <= *m_stoppedAt || module.latestTime == m_stoodAt)
        return Wait{};
    const auto position = module.stepper.position();
    const bool stands = !module.moving() && position;
    if (stands && m_stoodAt && position == m_stoodPosition)
        return go(module);
    m_stoodAt = stands ? std::optional(module.latestTime) : std::nullopt;
    m_stoodPosition = position;
    return Wait{};
}

Procedure::Next ChangeMotion::go(const ModuleState& module) {
    if (m_turn && m_turn != m_stoodPosition)
        return fail(ProcedureFailure::StoppedShort);
    const auto goal = goalOf(m_motion, *m_stoodPosition);
    m_turn = goal ? turningPoint(*goal, module) : std::nullopt;
    MotionSpec next = m_motion;
    if (m_turn) {
        if (!servo::kPositionRange.contains(*m_turn) || !servo::kPositionRange.contains(*goal))
            return fail(ProcedureFailure::TravelLimit);
        next = endingAt(static_cast<std::int32_t>(*m_turn), m_motion);
        // A relative goal stays where it is.
        m_motion = std::get<StepperMotion>(endingAt(static_cast<std::int32_t>(*goal), m_motion));
    }
    auto orders = planStep(intent::Move{next}, withoutBacklash(module));
    if (!orders)
        return fail(ProcedureFailure::Refused);
    m_report.stage = m_turn ? ProcedureStage::TakingUpBacklash : ProcedureStage::Moving;
    m_stoppedAt.reset();
    m_stoodAt.reset();
    m_mayRun = true;
    return send(std::move(*orders));
}

std::vector<bus::Order> ChangeMotion::lastWord(const ModuleState& module) const {
    // Until the new motion has been requested, the old one has either been sent a stop or was left alone.
    return m_mayRun ? std::vector{smoothStop(module)} : std::vector<bus::Order>{};
}

}  // namespace nmc
