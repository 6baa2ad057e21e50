// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/procedure/looptest.h"

namespace nmc {

/// One step of the command position of a PIC-SERVO at rest (DS-V 4.3), or one profiled move, to see how the
/// motor follows; the motor is then held at the goal. A motor that goes the wrong way, or twice as far, has
/// gone too far.
class StepResponseRun : public LoopTest {
public:
    /// `wanted` must be possible now.
    StepResponseRun(const intent::StepResponse& wanted, const ModuleState& module)
        : StepResponseRun(ProcedureKind::StepResponse, wanted, module) {}

protected:
    StepResponseRun(ProcedureKind kind, const intent::StepResponse& wanted, const ModuleState& module)
        : LoopTest(kind, module), m_wanted(wanted) {
        m_wanted.method = methodOf(wanted.method, module);
    }

    [[nodiscard]] Next settled(const ModuleState& module, bool stands) override;

    intent::StepResponse m_wanted;
    ResponseTaken m_taken;

private:
    [[nodiscard]] std::optional<Next> beforeStandstill(const ModuleState& module) override;
    [[nodiscard]] Next begin(const ModuleState& module) override;
    [[nodiscard]] Next goOn(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const override;
    [[nodiscard]] std::int32_t span() const override { return m_wanted.counts; }

    bool m_gainsSent = false;
    bool m_sent = false;  ///< the step has just been sent
};

}  // namespace nmc
