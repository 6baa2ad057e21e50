// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/looptest.h"

namespace nmc {

/// The command position of a PIC-SERVO jumps to and fro about the one that it held, and ends there
/// (DS-V 4.3). Each edge is told as ProcedureReport::step when it has been taken. Other gains are sent before
/// the edge after them. A motor that leaves the wave by more than its excursion has gone too far.
class SquareWaveRun : public LoopTest {
public:
    /// `wanted` is possible now.
    SquareWaveRun(const intent::SquareWave& wanted, const ModuleState& module);

    [[nodiscard]] bool take(const servo::SetGain& gains) override;

private:
    [[nodiscard]] Next begin(const ModuleState& module) override;
    [[nodiscard]] Next goOn(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next edge(const ModuleState& module);
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const override;
    [[nodiscard]] std::int32_t span() const override { return m_wanted.counts; }

    intent::SquareWave m_wanted;
    unsigned m_edges = 0;     ///< those that were commanded
    ResponseTaken m_taken;    ///< the last of them
    bool m_reported = false;  ///< in the report
    std::optional<servo::SetGain> m_next;
};

}  // namespace nmc
