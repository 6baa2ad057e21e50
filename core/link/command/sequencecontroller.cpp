// SPDX-License-Identifier: MIT
#include "link/command/sequencecontroller.h"

#include <utility>

#include "link/clock.h"
#include "model/intent/rights.h"
#include "model/procedure/procedures.h"
#include "model/sequence/sequencenews.h"

namespace nmc {

namespace {
constexpr int kSequenceIntervalMs = 50;

/// The modules as the run of that sequence sees them: homing has an operator right of its own.
template <typename Modules>
[[nodiscard]] Modules asOfRun(const std::string& sequence, Modules modules) {
    return sequence == kHomeAll ? modules : asOfSequence(std::move(modules));
}

}  // namespace

SequenceController::SequenceController(BusStore& store, ProcedureController& procedures, Submit submit,
                                       QObject* parent)
    : QObject(parent), m_store(store), m_procedures(procedures), m_submit(std::move(submit)) {
    m_timer.setInterval(kSequenceIntervalMs);
    connect(&m_timer, &QTimer::timeout, this, &SequenceController::look);
    connect(&m_store, &BusStore::linkChanged, this, &SequenceController::advance);
    connect(&m_procedures, &ProcedureController::reported, this, [this](const ProcedureReport& report) {
        if (running())
            m_run->onProcedure(report);
    });
    connect(&m_foresight, &BackgroundJob::ended, this,
            [this] { emit foreseen(*std::exchange(m_foreseen, nullptr)); });
}

void SequenceController::begin(SequenceRun run) {
    if (running())
        return;
    const LinkState& link = m_store.link();
    const auto& [sequence, row, rounds] = run.report().places.front();
    auto problems = whyNotRun(sequence, row, run.machine(), asOfRun(sequence, link.modules));
    if (link.phase != LinkPhase::Connected)
        problems = {{.kind = SequenceProblem::Kind::Refused,
                     .sequence = sequence,
                     .row = row,
                     .refusal = Refusal::NotConnected}};
    for (const ModuleIndex module : run.parts())
        if (problems.empty() && m_procedures.running(module) && !m_procedures.gainsBefore(module))
            problems.push_back({.kind = SequenceProblem::Kind::Refused,
                                .sequence = sequence,
                                .row = row,
                                .module = module,
                                .refusal = Refusal::Moving});
    if (!problems.empty()) {
        emit refused(problems);
        return;
    }
    for (const ModuleIndex module : run.parts())
        m_procedures.cancel(module);  // a trial of gains
    m_operations.clear();
    m_stops.clear();
    m_run = std::move(run);
    m_reported.reset();
    m_timer.start();
    advance();
}

/// Takes the events first: a stop from elsewhere must not be followed by a move.
void SequenceController::look() {
    m_store.drain();
    advance();
}

void SequenceController::advance() {
    // A run that ends with its connection is over before this turn, and has not been reported as such.
    if (!m_run || (m_reported && m_reported->over()))
        return;
    SequenceRun::Next next = m_run->next(asOfRun(name(), m_store.link().modules), monotonicNow());
    if (auto* send = std::get_if<SequenceRun::Send>(&next))
        for (std::vector<bus::Order>& orders : send->operations)
            (m_run->report().end ? m_stops : m_operations).push_back(m_submit(std::move(orders)));
    if (const auto* ask = std::get_if<SequenceRun::Ask>(&next))
        obey(*ask);
    publish();
    if (!running())
        m_timer.stop();
}

void SequenceController::obey(const SequenceRun::Ask& ask) {
    if (std::holds_alternative<intent::CancelProcedure>(ask.intent))
        return m_procedures.cancel(ask.module);
    const ModuleState* module = m_store.module(ask.module);
    const auto refusal = module != nullptr ? plan(ask.intent, asOfRun(name(), *module))
                                           : tl::unexpected(Refusal::Unresponsive);
    auto procedure = refusal ? procedureFor(ask.intent, asOfRun(name(), *module)) : nullptr;
    if (!procedure || !m_procedures.begin(std::move(procedure)))
        m_run->onNotBegun(ask.module, refusal ? Refusal::Moving : refusal.error());
}

void SequenceController::publish() {
    if (m_reported == m_run->report())
        return;
    m_reported = m_run->report();
    emit reported(*m_reported);
}

bool SequenceController::take(const StoreEvent& event) {
    if (const auto* finished = std::get_if<bus::OperationFinished>(&event)) {
        const bool isStop = std::erase(m_stops, finished->id) > 0;
        if (!m_run || (std::erase(m_operations, finished->id) == 0 && !isStop))
            return false;
        // A stop that was not carried out must be reported to the user, but not an order that it replaced.
        const bool replaced = !isStop && finished->outcome == bus::Outcome::Cancelled;
        const bool failed = m_run->report().end && finished->outcome != bus::Outcome::Done && !replaced;
        m_run->onFinished(finished->module, finished->outcome);
        return !failed;
    }
    if (!running())
        return true;
    std::visit(Overloaded{
                   [this](const AnyOf<ComputerSlept, GuardianStopped> auto&) { m_run->onLinkSuspect(); },
                   [this](const PanelFroze& froze) {
                       if (froze.stopped)
                           m_run->onStopOfAll();
                   },
                   [this](const PortClosed&) { m_run->onClosed(); },
                   [](const AnyOf<SimulatorAnswered, GuardianMissing, LineLent, LendingProblem> auto&) {},
                   [this](const auto& news) { SequenceNews{*m_run}(news); },
               },
               event);
    return true;
}

void SequenceController::foresee(const Machine& machine, const std::string& sequence, std::size_t row) {
    m_foresight.cancel();
    m_foreseen = std::make_shared<DryRun>();
    const LinkState& link = m_store.link();
    m_foresight.start([result = m_foreseen,
                       start = DryRunStart{machine, asOfSequence(link.modules), sequence, row, link.baud}](
                          const BackgroundJob::Cancelled& cancelled) { *result = dryRun(start, cancelled); });
}

}  // namespace nmc
