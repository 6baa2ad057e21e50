// SPDX-License-Identifier: MIT
#include "model/procedure/squarewave.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"

namespace nmc {

namespace {
/// Every edge would restart the rhythm of the polls, and all edges would be sampled at the same times. Each
/// edge is therefore followed by a read whose answer is a little longer each time.
constexpr std::array kFirstQuestions{
    StatusItems(StatusItems::Analog),
    StatusItems(StatusItems::Velocity),
    StatusItems(StatusItems::Velocity | StatusItems::Analog),
    StatusItems(StatusItems::Position),
    StatusItems(StatusItems::Position | StatusItems::Analog),
    StatusItems(StatusItems::Position | StatusItems::Velocity),
    StatusItems(StatusItems::Position | StatusItems::Velocity | StatusItems::Aux),
};
}  // namespace

SquareWaveRun::SquareWaveRun(const intent::SquareWave& wanted, const ModuleState& module)
    : LoopTest(ProcedureKind::SquareWave, module), m_wanted(wanted) {
    m_wanted.method = methodOf(wanted.method, module);
    m_report.rounds = wanted.rounds;
}

bool SquareWaveRun::take(const servo::SetGain& gains) {
    if (ends() || !edgeFollows() || wouldTrip(std::abs(std::int64_t{m_wanted.counts}), gains.el))
        return false;
    m_next = gains;
    return true;
}

SquareWaveRun::Next SquareWaveRun::begin(const ModuleState& module) {
    if (whyNot(m_wanted, module))
        return fail(ProcedureFailure::Refused);
    m_taken.goal = from();
    m_taken.gains = *module.gains;
    return edge(module);
}

/// The first edge goes from the middle to one side, all others from side to side.
SquareWaveRun::Next SquareWaveRun::edge(const ModuleState& module) {
    const std::int32_t half = m_wanted.counts / 2;
    const std::int32_t goal = m_edges % 2 == 0 ? from() + half : from() + half - m_wanted.counts;
    std::vector<bus::Order> sent;
    if (m_next) {
        m_taken.gains = gainsFor(module, *std::exchange(m_next, std::nullopt));
        sent = orders({m_taken.gains});
    }
    m_taken = {{}, m_taken.goal, goal, m_wanted.period / 2, m_wanted.method, m_taken.gains};
    m_reported = false;
    ++m_edges;
    m_report.round = std::min((m_edges + 1) / 2, m_report.rounds);  // the last edge ends the last round
    for (bus::Order& step : jump(module, goal, m_wanted.method))
        sent.push_back(std::move(step));
    sent.push_back(orders({ReadStatus{kFirstQuestions.at(m_edges / 2 % kFirstQuestions.size())}}).front());
    return send(std::move(sent));
}

SquareWaveRun::Next SquareWaveRun::goOn(const ModuleState& module, TimePoint now) {
    if (!std::exchange(m_reported, true)) {
        m_taken.at = module.motionCommandedAt;
        if (m_edges > 1)
            m_report.step = m_taken;
    }
    if (auto next = record(module, now, m_taken))
        return std::move(*next);
    return edgeFollows() ? edge(module) : conclude(module, from());
}

bool SquareWaveRun::goneTooFar(const ModuleState& module) const {
    const std::int64_t reach = std::abs(m_wanted.counts / 2) + std::int64_t{m_wanted.excursion};
    return std::abs(std::int64_t{countsBetween(stood(), *module.latest->position)}) > reach + kStillCounts;
}

}  // namespace nmc
