// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a module: a plan of commands at once, or a procedure that runs for a while.
#include <QDateTime>
#include <algorithm>
#include <utility>

#include "app/composition.h"
#include "link/clock.h"
#include "model/intent/homingplan.h"
#include "model/intent/rights.h"
#include "model/intent/travel.h"
#include "model/module/modulescale.h"
#include "model/procedure/procedures.h"
#include "model/response/responsefile.h"
#include "module/commandfacts.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/squarewavepage.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

void Composition::carryOut(ModuleIndex index, const Intent& intent) {
    m_scanWhenIdle = false;  // the user has gone on
    const ModuleState* module = m_store.module(index);
    if (module == nullptr)
        return;
    if (std::holds_alternative<intent::KeepGains>(intent)) {
        m_procedures.keep(index);
        return m_worker.keepTrial(index);
    }
    if (const auto* gains = std::get_if<intent::ApplyGains>(&intent);
        gains != nullptr && plan(intent, *module) && m_procedures.take(index, gains->gains))
        return m_machine.noteSent(index, intent);
    const bool stops = isStop(intent);
    if (!std::holds_alternative<intent::AskAnew>(intent))
        m_sequences.takeOver(index, stops);
    if (!stops)
        m_procedures.cancel(index);
    if (std::holds_alternative<intent::CancelProcedure>(intent))
        return;
    if (auto procedure = procedureFor(intent, *module)) {
        // The one before is still stopping its motor: nothing waits in a queue to move.
        if (!m_procedures.begin(std::move(procedure)))
            m_messages.tellOf(texts::notPossible(index, texts::refusal(Refusal::Moving)));
        return;
    }
    auto orders = plan(intent, *module);
    if (!orders) {
        m_procedures.cancel(index);
        const AxisScale scale = scaleOf(*module, m_machine.machine().axis(index));
        m_messages.tellOf(texts::notPossible(index, texts::refusal(orders.error(), intent, *module, scale)));
        return;
    }
    if (std::holds_alternative<intent::ResetModule>(intent))
        return m_worker.resetModule(index);
    if (const auto* save = std::get_if<intent::SaveConfiguration>(&intent))
        return m_worker.resetModule(index, save->configuration);
    if (const auto* declare = std::get_if<intent::DeclarePosition>(&intent))
        return m_store.declarePosition(index, declare->right);
    const bus::OperationId id = submit({.id = {}, .orders = std::move(*orders)});
    m_machine.noteSent(index, intent);
    if (stops)
        m_procedures.overtake(index);
    else
        m_store.noteAsked(index, id);
}

void Composition::hold(const bus::HoldToMove& wanted) {
    const ModuleState* module = m_store.module(wanted.module);
    if (module == nullptr)
        return;
    const auto hold = withinTravel(wanted, *module);
    if (!hold || whyNot(IntentKind::Hold, *module)) {
        m_window.endHold();  // the button says why
        return;
    }
    m_motionMarker.held(wanted.module, monotonicNow());
    m_sequences.takeOver(wanted.module, false);
    m_procedures.cancel(wanted.module);
    m_worker.hold(*hold);
}

void Composition::watchAxes() {
    if (m_store.link().phase != LinkPhase::Connected || m_store.link().readOnly)
        return;
    tellTravelLimits();
    for (const ModuleState& module : std::vector(m_store.link().modules))
        // A procedure sees to it itself.
        if (!module.silent && !m_procedures.running(module.info.index))
            keepArmed(module);
}

bool Composition::mayTell(ModuleIndex axis) {
    constexpr Duration kPatience = std::chrono::milliseconds(250);
    const TimePoint now = monotonicNow();
    const auto told = m_axisToldAt.find(axis);
    if (told != m_axisToldAt.end() && now - told->second < kPatience)
        return false;
    m_axisToldAt[axis] = now;
    return true;
}

void Composition::keepArmed(const ModuleState& module) {
    const auto arm = limitStopDue(module);
    if (!arm || module.awaited || !mayTell(module.info.index))
        return;
    if (auto orders = plan(*arm, asOfPanel(module)))
        submit({.id = {}, .orders = std::move(*orders)});
}

bus::OperationId Composition::submit(Procedure::Send send) {
    const bus::OperationId id(++m_lastOperation);
    std::vector<ModuleIndex> moved;
    for (const bus::Order& order : send.orders)
        if (mayStartMotion(order.command))
            moved.push_back(order.module);
    if (!moved.empty())
        m_motionMarker.asked(id, moved);
    send.id = id;
    m_worker.submit(std::move(send));
    return id;
}

void Composition::focusOn(const ProcedureReport& report) {
    if (report.over())
        m_tested.erase(report.module);
    else
        m_tested.insert(report.module);
    shareBus();
}

/// While another motor moves or is tested it is watched as closely as ever, and this one has fewer samples.
void Composition::shareBus() {
    const std::vector<ModuleState>& modules = m_store.link().modules;
    const bool alone = m_tested.size() == 1 &&
                       std::none_of(modules.begin(), modules.end(), [this](const ModuleState& other) {
                           return m_tested.count(other.info.index) == 0 && other.moving();
                       });
    const auto focused = alone ? std::optional(*m_tested.begin()) : std::nullopt;
    m_worker.focus(focused);
    m_store.noteFocus(focused);
}

void Composition::followSteps(const ProcedureReport& report) {
    const ModuleState* module = m_store.module(report.module);
    if (module == nullptr || !report.step)
        return;
    if (std::exchange(m_steps[report.module], *report.step) != *report.step)
        keepRun(*module, *report.step);
    if (report.kind == ProcedureKind::StepSeries && report.stage == ProcedureStage::Done)
        m_window.stepResponses().page().find(report.module);
}

void Composition::followSquareWave(const ProcedureReport& report) {
    const ModuleState* module = m_store.module(report.module);
    const auto last = m_edges.find(report.module);
    const bool next = last == m_edges.end() || report.step != last->second;
    if (last != m_edges.end() && module != nullptr && (next || report.stage == ProcedureStage::Stopping))
        if (auto edge = recordOf(*module, last->second))
            m_window.loopTests().squareWave().showEdge(std::move(*edge));
    if (report.over() || report.stage == ProcedureStage::Stopping) {
        m_edges.erase(report.module);
    } else if (report.step) {
        if (last == m_edges.end())
            m_window.loopTests().squareWave().clear();
        m_edges[report.module] = *report.step;
    }
}

void Composition::keepRun(const ModuleState& module, const ResponseTaken& taken) {
    if (auto run = recordOf(module, taken))
        m_window.showResponse(*run);
}

std::optional<KeptResponse> Composition::recordOf(const ModuleState& module,
                                                  const ResponseTaken& taken) const {
    const ModuleIndex index = module.info.index;
    const ModuleHistory* history = m_store.history().module(index);
    if (history == nullptr)
        return std::nullopt;
    const auto samples = history->samples(taken.at - kBeforeStep, taken.at + fromSeconds(taken.record));
    const auto ago = std::chrono::duration_cast<std::chrono::milliseconds>(monotonicNow() - taken.at);
    const QDateTime started = QDateTime::currentDateTime().addMSecs(-ago.count());
    KeptResponse kept;
    kept.run = takeRun(index, samples, taken, kFirstBand);
    kept.startedAt = isoDate(started).toStdString();
    kept.moduleName = texts::moduleName(index).toStdString();
    kept.axisName = m_machine.machine().axis(index).name;
    kept.scale = scaleOf(module, m_machine.machine().axis(index));
    kept.port = m_store.link().port;
    kept.simulated = m_store.link().simulated;
    return kept;
}

void Composition::showProcedure(const ProcedureReport& report) {
    m_window.showProcedure(report);
    if (isTest(report.kind))
        focusOn(report);
    if (makesSteps(report.kind))
        followSteps(report);
    if (report.kind == ProcedureKind::SquareWave)
        followSquareWave(report);
    if (report.kind == ProcedureKind::FrequencyResponse && !report.frequencies.empty())
        m_window.loopTests().frequency().showReport(report);
    const ModuleState* module = m_store.module(report.module);
    if (!report.over())
        return m_messages.end(texts::key::procedure(report.module));
    if (module == nullptr)
        return;
    const AxisScale scale = scaleOf(*module, m_machine.machine().axis(report.module));
    if (const auto message = texts::procedureEnded(report, scale))
        m_messages.tellOf(*message);
}

}  // namespace nmc
