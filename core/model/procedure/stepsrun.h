// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/intent/intent.h"
#include "model/procedure/looptest.h"

namespace nmc {

/// Steps of the command position of a PIC-SERVO at rest (DS-V 4.3), or profiled moves, to see how the motor
/// follows; it is then held at the goal. Each step of a series begins at the end of the previous one, as soon
/// as the motor stands there; one after which it does not come to rest is the last. A motor that goes the
/// wrong way, or twice as far, has gone too far.
class StepsRun : public LoopTest {
public:
    /// `wanted` must be possible now.
    StepsRun(const intent::StepResponse& wanted, const ModuleState& module);
    StepsRun(const intent::StepSeries& wanted, const ModuleState& module);

private:
    [[nodiscard]] std::optional<Next> beforeStandstill(const ModuleState& module) override;
    [[nodiscard]] Next begin(const ModuleState& module) override;
    [[nodiscard]] Next goOn(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next settled(const ModuleState& module, bool stands) override;
    [[nodiscard]] bool goneTooFar(const ModuleState& module) const override;
    [[nodiscard]] std::int32_t span() const override { return m_wanted.counts; }

    intent::StepResponse m_wanted;       ///< the present step
    std::vector<std::int32_t> m_counts;  ///< the distance of each step of a series
    ResponseTaken m_taken;
    bool m_gainsSent = false;
    bool m_sent = false;  ///< the step has just been sent
};

}  // namespace nmc
