// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a module: a plan of commands at once, or a procedure that runs for a while.
#include "app/composition.h"
#include "model/modulescale.h"
#include "model/procedures.h"
#include "widgets/common/texts.h"

namespace nmc {

void Composition::carryOut(ModuleIndex index, const Intent& intent) {
    const ModuleState* module = m_store.module(index);
    if (module == nullptr)
        return;
    const bool stops = isStop(intent);
    if (!stops)
        m_procedures.cancel(index);
    if (std::holds_alternative<intent::CancelProcedure>(intent))
        return;
    if (auto procedure = procedureFor(intent, *module)) {
        // The one before is still stopping its motor: nothing waits in a queue to move.
        if (!m_procedures.begin(std::move(procedure)))
            m_window.showMessage(texts::notPossible(index, Refusal::Moving));
        return;
    }
    auto steps = plan(intent, *module);
    if (!steps) {
        m_procedures.cancel(index);
        m_window.showMessage(texts::notPossible(index, steps.error()));
        return;
    }
    submit(std::move(*steps));
    m_machine.noteSent(index, intent);
    if (stops)
        m_procedures.overtake(index);
}

bus::OperationId Composition::submit(std::vector<bus::Step> steps) {
    const bus::OperationId id(++m_lastOperation);
    m_worker.submit({id, std::move(steps)});
    return id;
}

void Composition::showProcedure(const ProcedureReport& report) {
    m_window.showProcedure(report);
    const ModuleState* module = m_store.module(report.module);
    if (!report.over() || module == nullptr)
        return;
    const AxisScale scale = scaleOf(*module, m_machine.machine().axis(report.module));
    if (const auto message = texts::procedureEnded(report, scale))
        m_window.showMessage(*message);
}

}  // namespace nmc
