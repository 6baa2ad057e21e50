// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to a module, and the progress of procedures.
#include <QDateTime>
#include <utility>

#include "app/composition.h"
#include "link/clock.h"
#include "model/module/modulescale.h"
#include "model/response/responsefile.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/squarewavepage.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

void Composition::carryOut(ModuleIndex module, const Intent& intent) {
    m_scanWhenIdle = false;  // the user has moved on
    m_commander.carryOut(module, intent);
}

void Composition::refuse(ModuleIndex index, Refusal refusal, const Intent& intent) {
    const ModuleState& module = *m_store.module(index);
    const AxisScale scale = scaleOf(module, m_machine.machine().axis(index));
    m_messages.reportOf(texts::notPossible(index, texts::refusal(refusal, intent, module, scale)));
}

void Composition::hold(const bus::HoldToMove& hold) {
    if (!m_commander.hold(hold))
        m_window.endHold();  // the button shows why
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
        m_messages.reportOf(*message);
}

}  // namespace nmc
