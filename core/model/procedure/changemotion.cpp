// SPDX-License-Identifier: MIT
#include "model/procedure/changemotion.h"

#include "model/intent/stepperplan.h"

namespace nmc {

Procedure::Next ChangeMotion::proceed(const ModuleState& module, TimePoint now) {
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    if (m_report.stage == ProcedureStage::Preparing)
        return stop(module, now);
    return m_report.stage == ProcedureStage::Stopping ? waitForStandstill(module, now) : finish();
}

Procedure::Next ChangeMotion::stop(const ModuleState& module, TimePoint now) {
    // A motion that is impossible from standstill too is no reason to stop a motor.
    if (whyNotFromStandstill(m_motion, module))
        return fail(ProcedureFailure::Refused);
    m_began = now;
    m_report.stage = ProcedureStage::Stopping;
    return send({smoothStop(module)});
}

/// Standstill must be confirmed by two statuses latched after the stop.
Procedure::Next ChangeMotion::waitForStandstill(const ModuleState& module, TimePoint now) {
    if (!module.stepper.amplifierOn())
        return fail(ProcedureFailure::WentOff);
    if (now - m_began > kStopLimit)
        return fail(ProcedureFailure::TimeLimit);
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
    auto orders = planStep(intent::Move{m_motion}, module);
    if (!orders)
        return fail(ProcedureFailure::Refused);
    m_report.stage = ProcedureStage::Moving;
    m_mayRun = true;
    return send(std::move(*orders));
}

std::vector<bus::Order> ChangeMotion::lastWord(const ModuleState& module) const {
    // Until the new motion has been requested, the old one has either been sent a stop or was left alone.
    return m_mayRun ? std::vector{smoothStop(module)} : std::vector<bus::Order>{};
}

}  // namespace nmc
