// SPDX-License-Identifier: MIT
#include "model/procedure/stepsrun.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"
#include "model/intent/moveforecast.h"

namespace nmc {

StepsRun::StepsRun(const intent::StepResponse& wanted, const ModuleState& module)
    : LoopTest(ProcedureKind::StepResponse, module), m_wanted(wanted) {
    m_wanted.method = methodOf(wanted.method, module);
}

StepsRun::StepsRun(const intent::StepSeries& wanted, const ModuleState& module)
    : LoopTest(ProcedureKind::StepSeries, module), m_wanted(wanted.each), m_counts(wanted.counts) {
    m_wanted.method = methodOf(wanted.each.method, module);
    m_wanted.counts = m_counts.front();
    m_report.rounds = static_cast<unsigned>(m_counts.size());
    m_report.round = 1;
}

std::optional<StepsRun::Next> StepsRun::beforeStandstill(const ModuleState& module) {
    if (m_wanted.gains && !std::exchange(m_gainsSent, true))
        return send(orders({gainsFor(module, *m_wanted.gains)}));
    return std::nullopt;
}

StepsRun::Next StepsRun::begin(const ModuleState& module) {
    if (whyNot(m_wanted, module))
        return fail(ProcedureFailure::Refused);
    m_taken = {{},
               from(),
               from() + m_wanted.counts,
               m_wanted.record,
               m_wanted.method,
               *module.gains,
               m_wanted.pace,
               std::max(m_report.round, 1U)};
    m_sent = true;
    if (!m_taken.isMove())
        return send(jump(module, m_taken.goal, m_wanted.method));
    m_taken.record += forecast(m_wanted.counts, m_wanted.pace, module.gains->sr).seconds;
    return send(jump(module, m_taken.goal, m_wanted.method, m_wanted.pace));
}

StepsRun::Next StepsRun::goOn(const ModuleState& module, TimePoint now) {
    if (std::exchange(m_sent, false))
        m_taken.at = module.motionCommandedAt;
    if (auto next = record(module, now, m_taken))
        return std::move(*next);
    return conclude(module, m_taken.goal);
}

/// The record is complete even if the motor does not come to rest afterwards.
StepsRun::Next StepsRun::settled(const ModuleState& module, bool stands) {
    m_report.step = m_taken;
    if (!stands || m_report.round == m_report.rounds)
        return LoopTest::settled(module, stands);
    m_wanted.counts = m_counts[m_report.round++];
    return start(module);
}

/// No stable servo overshoots by a whole step, or swings back beyond where it came from.
bool StepsRun::goneTooFar(const ModuleState& module) const {
    if (module.latestTime <= m_taken.at)
        return false;
    const std::int64_t step = std::abs(std::int64_t{m_wanted.counts});
    const std::int64_t gone = countsBetween(stood(), *module.latest->position);
    const std::int64_t distance = m_wanted.counts < 0 ? -gone : gone;
    return distance > 2 * step + kStillCounts || distance < -step / 4 - kStillCounts;
}

}  // namespace nmc
