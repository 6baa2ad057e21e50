// SPDX-License-Identifier: MIT
#include "model/procedure/changemotion.h"

#include "model/intent/stepplan.h"

namespace nmc {

Procedure::Next ChangeMotion::next(const ModuleState& module, TimePoint now) {
    if (m_haltOwed)
        return halt(module);
    if (report().over())
        return End{};
    if (m_waiting)
        return Wait{};
    if (module.silent)
        return fail(ProcedureFailure::ModuleSilent);
    switch (m_stage) {
        case ProcedureStage::Preparing:
            return stop(module, now);
        case ProcedureStage::Stopping:
            return waitForStandstill(module, now);
        case ProcedureStage::Moving:
            m_stage = ProcedureStage::Done;
            return End{};
        case ProcedureStage::BackingOff:
        case ProcedureStage::Searching:
        case ProcedureStage::SearchingIndex:
        case ProcedureStage::Reading:
        case ProcedureStage::GoingHome:
        case ProcedureStage::Zeroing:
        case ProcedureStage::Pausing:
        case ProcedureStage::Done:
        case ProcedureStage::Failed:
        case ProcedureStage::Cancelled:
            break;
    }
    return End{};
}

Procedure::Next ChangeMotion::stop(const ModuleState& module, TimePoint now) {
    // What is not possible afterwards either is no reason to stop a motor.
    if (whyNotFromStandstill(m_motion, module))
        return fail(ProcedureFailure::Refused);
    m_began = now;
    m_stage = ProcedureStage::Stopping;
    m_waiting = true;
    return Send{{smoothStop(module)}};
}

/// Confirmed twice, by statuses that were latched after the stop.
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
    auto steps = planStep(stepintent::Move{m_motion}, module);
    if (!steps)
        return fail(ProcedureFailure::Refused);
    m_stage = ProcedureStage::Moving;
    m_waiting = m_mayRun = true;
    return Send{std::move(*steps)};
}

Procedure::Next ChangeMotion::halt(const ModuleState& module) {
    m_haltOwed = false;
    m_waiting = true;
    return Send{{smoothStop(module)}};
}

Procedure::Next ChangeMotion::fail(ProcedureFailure failure) {
    m_stage = ProcedureStage::Failed;
    m_failure = failure;
    return End{};
}

void ChangeMotion::onFinished(bus::Outcome outcome) {
    m_waiting = false;
    if (report().over() || outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled)
        return cancel();
    // A start that was not answered may have been carried out.
    m_haltOwed = m_mayRun;
    fail(ProcedureFailure::Refused);
}

void ChangeMotion::onLinkSuspect() {
    if (report().over())
        return;
    m_haltOwed = m_mayRun;
    fail(ProcedureFailure::LinkSuspect);
}

void ChangeMotion::cancel() {
    if (report().over())
        return;
    m_haltOwed = m_mayRun;
    m_stage = ProcedureStage::Cancelled;
}

ProcedureReport ChangeMotion::report() const {
    ProcedureReport report;
    report.module = m_module;
    report.kind = ProcedureKind::ChangeMotion;
    report.stage = m_stage;
    report.failure = m_failure;
    return report;
}

}  // namespace nmc
