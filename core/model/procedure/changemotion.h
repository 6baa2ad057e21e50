// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/steppermotion.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Stop, wait, go: what a PIC-STEP needs between two motions that its Table 4 does not join, a change of
/// direction above all (DS-S 4.1, 4.2). It stops smoothly, waits until two statuses say that it stands at the
/// same place, and starts the new motion. A relative goal counts from there.
class ChangeMotion : public Procedure {
public:
    ChangeMotion(ModuleIndex module, StepperMotion motion)
        : Procedure(module, ProcedureKind::ChangeMotion), m_motion(motion) {}

private:
    /// Slowing down from speed 250 at the longest acceleration time takes 15.9 s (DS-S 4.2).
    static constexpr Duration kStopLimit = std::chrono::seconds(20);

    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next stop(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next waitForStandstill(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next go(const ModuleState& module);

    StepperMotion m_motion;
    TimePoint m_began;
    std::optional<TimePoint> m_stoppedAt;  ///< the last status before the stop was confirmed
    std::optional<TimePoint> m_stoodAt;    ///< the first status that says so
    std::optional<std::int32_t> m_stoodPosition;
};

}  // namespace nmc
