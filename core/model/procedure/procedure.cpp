// SPDX-License-Identifier: MIT
#include "model/procedure/procedure.h"

#include <utility>

#include "model/intent/travel.h"

namespace nmc {

Procedure::Procedure(ModuleIndex module, ProcedureKind kind) {
    m_report.module = module;
    m_report.kind = kind;
}

Procedure::Next Procedure::next(const ModuleState& module, TimePoint now) {
    // The next reply decides whether this is a failure, and also whether a stop is needed: to a motor that is
    // off, none is sent.
    if (module.maybeOff() && !m_report.over())
        return Wait{};
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
    if (std::holds_alternative<End>(rest) && !m_report.over())
        m_report.stage = *m_end;
    return rest;
}

std::vector<bus::Order> Procedure::orders(std::vector<ServoCommand> commands) const {
    std::vector<bus::Order> orders;
    for (ServoCommand& command : commands)
        orders.push_back({m_report.module, std::move(command)});
    return orders;
}

void Procedure::onFinished(bus::Outcome outcome, bus::SineRecord sine, std::optional<bus::TrialEnd> trial) {
    m_inFlight = false;
    m_swung = std::move(sine);
    m_tried = trial;
    m_report.kept |= trial == bus::TrialEnd::Kept;
    if (outcome == bus::Outcome::Cancelled)
        m_mayRun = false;  // the cause of that has stopped the motor, or switched it off
    if (outcome == bus::Outcome::QueueFull && ends())
        m_lastWordSent = false;  // it still has to go out
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
        m_mayRun = false;  // whatever is wanted instead takes care of the rest
    if (!ends())
        m_end = ProcedureStage::Cancelled;
}

Procedure::Next Procedure::start(Send operation, bool lasts) {
    m_inFlight = true;
    m_lasts = lasts;
    return operation;
}

Procedure::Next Procedure::send(std::vector<bus::Order> orders) {
    return start({.id = {}, .orders = std::move(orders)}, false);
}

Procedure::Next Procedure::swing(bus::Order centre, const bus::Sine& sine) {
    return start({.id = {}, .orders = {std::move(centre)}, .sine = sine}, true);
}

Procedure::Next Procedure::follow(std::vector<bus::Order> starts, std::shared_ptr<const bus::PathPlan> path) {
    return start({.id = {}, .orders = std::move(starts), .path = std::move(path)}, true);
}

Procedure::Next Procedure::tryOut(bus::Order gains, const bus::GainTrial& trial) {
    return start({.id = {}, .orders = {std::move(gains)}, .trial = trial}, true);
}

bool Procedure::passesNewLimit(std::int64_t goal, const ModuleState& module) {
    const auto travel = travelRange(module);
    return travel != std::exchange(m_travel, travel) && travel && module.position() &&
           beyondTravel(*module.position(), goal, *travel);
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
