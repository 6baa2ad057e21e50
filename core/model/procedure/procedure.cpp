// SPDX-License-Identifier: MIT
#include "model/procedure/procedure.h"

#include <tuple>
#include <utility>

namespace nmc {

Procedure::Procedure(ModuleIndex module, ProcedureKind kind) {
    m_report.module = module;
    m_report.kind = kind;
}

Procedure::Next Procedure::next(const ModuleState& module, TimePoint now) {
    if (interruptible()) {
        whileItLasts(module);
        m_inFlight = !m_end;
    }
    if (m_inFlight)
        return Wait{};
    if (m_report.over())
        return End{};
    if (!m_end) {
        Next next = proceed(module, now);
        if (!m_end)
            return next;
    }
    if (!std::exchange(m_lastWordSent, true)) {
        if (auto orders = lastWord(module); !orders.empty()) {
            m_report.stage = ProcedureStage::Stopping;
            return send(std::move(orders));
        }
    }
    Next rest = afterLastWord(module, now);
    if (std::holds_alternative<End>(rest))
        m_report.stage = *m_end;
    return rest;
}

void Procedure::onFinished(bus::Outcome outcome, bus::SineRecord sine) {
    m_inFlight = false;
    m_outcome = outcome;
    m_swung = std::move(sine);
    if (outcome == bus::Outcome::Cancelled)
        m_mayRun = false;  // whoever did that has stopped the motor, or switched it off
    if (m_end || outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled)
        m_end = ProcedureStage::Cancelled;
    else
        std::ignore = fail(ProcedureFailure::Refused);
}

void Procedure::onLinkSuspect() {
    std::ignore = fail(ProcedureFailure::LinkSuspect);
}

void Procedure::cancel() {
    if (m_lastWordSent)
        m_mayRun = false;  // whoever wants something else now sees to the rest
    if (!ends())
        m_end = ProcedureStage::Cancelled;
}

Procedure::Next Procedure::send(std::vector<bus::Order> orders) {
    m_inFlight = true;
    m_lasts = false;
    return Send{std::move(orders)};
}

Procedure::Next Procedure::swing(bus::Order centre, const bus::Sine& sine) {
    m_inFlight = true;
    m_lasts = true;
    return Send{{std::move(centre)}, sine};
}

Procedure::Next Procedure::follow(std::vector<bus::Order> starts, std::shared_ptr<const bus::PathPlan> path) {
    m_inFlight = true;
    m_lasts = true;
    return Send{std::move(starts), {}, std::move(path)};
}

Procedure::Next Procedure::finish() {
    m_report.stage = ProcedureStage::Done;
    return End{};
}

Procedure::Next Procedure::fail(ProcedureFailure failure) {
    if (!ends()) {
        m_end = ProcedureStage::Failed;
        m_report.failure = failure;
    }
    return Wait{};
}

}  // namespace nmc
