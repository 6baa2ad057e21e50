// SPDX-License-Identifier: MIT
#include "link/command/procedurecontroller.h"

#include <utility>

#include "base/overloaded.h"
#include "link/clock.h"
#include "model/intent/rights.h"
#include "model/procedure/procedures.h"

namespace nmc {

namespace {

constexpr int kProcedureIntervalMs = 50;

/// True for a trial that has ended, but for the gains from before, which are on their way. Another trial
/// would go back to the ones that it finds.
[[nodiscard]] bool givesWay(const Procedure& trial, const Procedure& next) {
    return trial.report().kind == ProcedureKind::TryGains && trial.ends() && !trial.stopsLater() &&
           next.report().kind != ProcedureKind::TryGains;
}

}  // namespace

ProcedureController::ProcedureController(BusStore& store, Submit submit, QObject* parent)
    : QObject(parent), m_store(store), m_submit(std::move(submit)) {
    m_timer.setInterval(kProcedureIntervalMs);
    connect(&m_timer, &QTimer::timeout, this, &ProcedureController::look);
    connect(&m_store, &BusStore::linkChanged, this, &ProcedureController::advance);
}

bool ProcedureController::begin(std::unique_ptr<Procedure> procedure) {
    const ModuleIndex module = procedure->report().module;
    if (const auto found = m_runs.find(module); found != m_runs.end()) {
        if (!givesWay(*found->second.procedure, *procedure))
            return false;
        end(found->second);
    }
    Run& run = m_runs[module];
    // It begins when the gains from before a trial are back.
    run = Run{std::move(procedure), run.operation, std::nullopt, false};
    publish(run);
    m_timer.start();
    advance();
    return true;
}

void ProcedureController::cancel(ModuleIndex module) {
    const auto found = m_runs.find(module);
    if (found == m_runs.end())
        return;
    found->second.procedure->cancel();
    advance();
}

std::optional<servo::SetGain> ProcedureController::gainsBefore(ModuleIndex module) const {
    const auto found = m_runs.find(module);
    const bool tries = found != m_runs.end() && found->second.procedure->report().tries();
    return tries ? found->second.procedure->report().gains : std::nullopt;
}

bool ProcedureController::stopsLater(ModuleIndex module) const {
    const auto found = m_runs.find(module);
    return found != m_runs.end() && !found->second.overtaken && found->second.procedure->stopsLater();
}

void ProcedureController::cancelAll() {
    for (auto& [module, run] : m_runs)
        run.procedure->cancel();
    advance();
}

void ProcedureController::keep(ModuleIndex module) {
    if (const auto found = m_runs.find(module); found != m_runs.end())
        found->second.procedure->keep();
}

bool ProcedureController::take(ModuleIndex module, const servo::SetGain& gains) {
    const auto found = m_runs.find(module);
    return found != m_runs.end() && found->second.procedure->take(gains);
}

void ProcedureController::overtake(ModuleIndex module) {
    const auto found = m_runs.find(module);
    if (found == m_runs.end())
        return;
    end(found->second);
    advance();
}

void ProcedureController::overtakeAll() {
    for (auto& [module, run] : m_runs)
        end(run);
    advance();
}

void ProcedureController::end(Run& run) {
    run.procedure->cancel();
    publish(run);
    if (run.overtaken || run.reported->over())
        return;
    run.overtaken = true;
    ProcedureReport cancelled = run.procedure->report();
    cancelled.stage = ProcedureStage::Cancelled;
    report(run, cancelled);
}

void ProcedureController::stopAll() {
    m_stopping = true;
    overtakeAll();
}

void ProcedureController::forget() {
    m_stopping = false;
    for (auto& [module, run] : m_runs)
        end(run);
    m_runs.clear();
    m_replaced.clear();
    m_timer.stop();
    emitReports();
}

/// Takes the events first: a stop from elsewhere must not be followed by a move.
void ProcedureController::look() {
    m_store.drain();
    advance();
}

void ProcedureController::advance() {
    const TimePoint now = monotonicNow();
    const bool ran = anyRunning();
    for (auto it = m_runs.begin(); it != m_runs.end() && !m_stopping;) {
        bool over = false;
        if (const ModuleState* module = m_store.module(it->first))
            ask(it->second, *module, now, over);
        it = over ? m_runs.erase(it) : std::next(it);
    }
    if (m_runs.empty())
        m_timer.stop();
    emitReports();
    if (ran && m_runs.empty())
        emit idle();
}

void ProcedureController::ask(Run& run, const ModuleState& module, TimePoint now, bool& over) {
    if (run.operation && !run.procedure->interruptible())
        return;
    Procedure::Next next = run.procedure->next(asOfPanel(module), now);
    if (auto* send = std::get_if<Procedure::Send>(&next)) {
        if (run.overtaken)
            keepWhatIsHarmless(send->orders);
        if (run.procedure->ends())
            if (auto stops = takeStops(send->orders); !stops.empty())
                replace(run, m_submit({.id = {}, .orders = std::move(stops)}));
        if (send->orders.empty())
            run.procedure->onFinished(bus::Outcome::Done);
        else
            replace(run, m_submit(std::move(*send)));
    }
    over = std::holds_alternative<Procedure::End>(next);
    if (over)
        replace(run, std::nullopt);
    publish(run);
}

/// The end of what it replaces is the procedure's doing, and no news.
void ProcedureController::replace(Run& run, std::optional<bus::OperationId> next) {
    if (const auto before = std::exchange(run.operation, next))
        m_replaced.push_back(*before);
}

void ProcedureController::publish(Run& run) {
    const ProcedureReport report = run.procedure->report();
    if (run.overtaken || run.reported == report)
        return;
    if (report.kind == ProcedureKind::Homing && report.home && !(run.reported && run.reported->home))
        m_store.noteHome(report.module, *report.home);
    this->report(run, report);
}

void ProcedureController::report(Run& run, const ProcedureReport& report) {
    run.reported = report;
    m_reports.push_back(report);
}

/// Only when what has ended is gone: a receiver of the report may begin the next one.
void ProcedureController::emitReports() {
    while (!m_reports.empty()) {
        const ProcedureReport report = m_reports.front();
        m_reports.pop_front();
        emit reported(report);
    }
}

void ProcedureController::suspect(std::optional<ModuleIndex> module) {
    for (auto& [index, run] : m_runs)
        if (!module || *module == index)
            run.procedure->onLinkSuspect();
}

bool ProcedureController::finished(const bus::OperationFinished& finished) {
    if (std::erase(m_replaced, finished.id) > 0)
        return true;
    for (auto& [module, run] : m_runs)
        if (run.operation == finished.id) {
            run.operation.reset();
            run.procedure->onFinished(finished.outcome, finished.sine, finished.trial);
            return true;
        }
    return false;
}

bool ProcedureController::take(const StoreEvent& event) {
    if (const auto* end = std::get_if<bus::OperationFinished>(&event))
        return finished(*end);
    std::visit(
        Overloaded{
            [this](const AnyOf<bus::ModuleUnresponsive, bus::ModuleRestarted> auto& news) {
                suspect(news.module);
            },
            [this](const bus::HealthChanged& changed) {
                if (changed.health != bus::LinkHealth::Good)
                    suspect(changed.module);
            },
            [this](const AnyOf<ComputerSlept, GuardianStopped, bus::LinkLost> auto&) {
                suspect(std::nullopt);
            },
            [this](
                const AnyOf<bus::MotionSuspect, bus::StoppedBeforeLimit, bus::ForeignMotion> auto& motion) {
                overtake(motion.module);
            },
            [this](const bus::ForeignTraffic&) { overtakeAll(); },
            [this](const PanelFroze& froze) {
                if (froze.stopped)
                    overtakeAll();
            },
            [this](const bus::StopFinished&) {
                // Also applies to a stop that this side did not request.
                m_stopping = false;
                overtakeAll();
            },
            [this](const AnyOf<bus::ChainFound, bus::ConnectFailed, PortClosed> auto&) { forget(); },
            // These events end a procedure's operation, show in the module's state, or do not concern a
            // motor.
            [](const AnyOf<bus::OperationFinished, bus::CommandRefused, bus::HoldExpired, bus::GroupFinished,
                           bus::RateChanged, bus::RateChangeFailed, bus::OwedStopConfirmed, bus::Readdressed,
                           bus::ReaddressFailed, bus::AddressChanged, bus::EchoNoticed, SimulatorAnswered,
                           GuardianMissing, LineLent, LendingProblem> auto&) {},
        },
        event);
    return true;
}

}  // namespace nmc
