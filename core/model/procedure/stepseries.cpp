// SPDX-License-Identifier: MIT
#include "model/procedure/stepseries.h"

namespace nmc {

StepSeriesRun::StepSeriesRun(const intent::StepSeries& wanted, const ModuleState& module)
    : StepResponseRun(ProcedureKind::StepSeries, wanted.each, module), m_counts(wanted.counts) {
    m_wanted.counts = m_counts.front();
    m_report.rounds = static_cast<unsigned>(m_counts.size());
    m_report.round = 1;
}

StepSeriesRun::Next StepSeriesRun::settled(const ModuleState& module, bool stands) {
    if (!stands || m_report.round == m_report.rounds)
        return StepResponseRun::settled(module, stands);
    m_report.step = m_taken;
    m_wanted.counts = m_counts[m_report.round++];
    return start(module);
}

}  // namespace nmc
