// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/looptest.h"

namespace nmc {

/// The command position of a PIC-SERVO jumps to and fro about the position that it held, and ends there (DS-V
/// 4.3). Each edge is reported as ProcedureReport::step when it has been recorded. New gains are sent before
/// the next edge. A motor that leaves the wave by more than its excursion has gone too far.
class SquareWaveRun : public LoopTest {
public:
    /// `wanted` must be possible now.
    SquareWaveRun(const intent::SquareWave& wanted, const ModuleState& module);

    [[nodiscard]] bool take(const servo::SetGain& gains) override;

private:
    [[nodiscard]] Next begin(const ModuleState& module) override;
    [[nodiscard]] Next goOn(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next edge(const ModuleState& module);
    /// The first edge is only half an edge, so there is one more than two in each round.
    [[nodiscard]] bool edgeFollows() const { return m_edges <= 2 * m_wanted.rounds; }
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const override;
    [[nodiscard]] std::int32_t span() const override { return m_wanted.counts; }

    intent::SquareWave m_wanted;
    unsigned m_edges = 0;     ///< number of edges commanded
    ResponseTaken m_taken;    ///< the last edge
    bool m_reported = false;  ///< the last edge is in the report
    std::optional<servo::SetGain> m_next;
};

}  // namespace nmc
