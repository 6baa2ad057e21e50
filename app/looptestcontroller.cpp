// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/looptestcontroller.h"

#include <utility>

#include "link/clock.h"
#include "model/module/modulescale.h"
#include "widgets/common/dates.h"
#include "widgets/common/words.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/squarewavepage.h"
#include "widgets/response/responsedock.h"

namespace nmc {

LoopTestController::LoopTestController(MainWindow& window, const BusStore& store,
                                       const ProcedureController& procedures)
    : m_window(window), m_store(store) {
    connect(&procedures, &ProcedureController::reported, this, &LoopTestController::take);
}

void LoopTestController::take(const ProcedureReport& report) {
    if (makesSteps(report.kind))
        followSteps(report);
    if (report.kind == ProcedureKind::SquareWave)
        followSquareWave(report);
    if (report.kind == ProcedureKind::FrequencyResponse)
        m_window.loopTests().frequency().showReport(report, QString::fromStdString(m_store.link().port),
                                                    m_store.link().simulated);
}

void LoopTestController::followSteps(const ProcedureReport& report) {
    const ModuleState* module = m_store.module(report.module);
    if (module == nullptr || !report.step)
        return;
    if (std::exchange(m_steps[report.module], *report.step) != *report.step)
        if (const auto run = recordOf(*module, *report.step))
            m_window.stepResponses().showRun(*run);
    if (report.kind == ProcedureKind::StepSeries && report.stage == ProcedureStage::Done &&
        !report.step->isMove())
        m_window.stepResponses().page().model().find(report.module);
}

void LoopTestController::followSquareWave(const ProcedureReport& report) {
    const ModuleState* module = m_store.module(report.module);
    const auto last = m_edges.find(report.module);
    const bool next = last == m_edges.end() || report.step != last->second;
    const bool ends = next || report.stage == ProcedureStage::Stopping;
    // The record of an edge is cut off where the user ends the test.
    if (last != m_edges.end() && module != nullptr && ends &&
        monotonicNow() - last->second.at >= fromSeconds(last->second.record))
        if (auto edge = recordOf(*module, last->second))
            m_window.loopTests().squareWave().showEdge(std::move(*edge));
    if (report.over() || report.stage == ProcedureStage::Stopping) {
        m_edges.erase(report.module);
    } else if (report.step) {
        if (last == m_edges.end())
            m_window.loopTests().squareWave().clear(report.module);
        m_edges[report.module] = *report.step;
    }
}

std::optional<KeptResponse> LoopTestController::recordOf(const ModuleState& module,
                                                         const ResponseTaken& taken) const {
    const ModuleIndex index = module.info.index;
    const ModuleHistory* history = m_store.history().module(index);
    if (history == nullptr)
        return std::nullopt;
    const auto samples = history->samples(taken.at - kBeforeStep, taken.at + fromSeconds(taken.record));
    const AxisSettings axis = m_store.machine().axis(index);
    KeptResponse kept;
    kept.run = takeRun(index, samples, taken, kFirstBand);
    kept.startedAt = isoDate(dateOf(taken.at, monotonicNow())).toStdString();
    kept.moduleName = texts::moduleName(index).toStdString();
    kept.axisName = axis.name;
    kept.scale = scaleOf(module, axis);
    kept.port = m_store.link().port;
    kept.simulated = m_store.link().simulated;
    return kept;
}

}  // namespace nmc
