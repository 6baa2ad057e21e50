// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/intent/motion.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Stop, wait, go: required by a PIC-STEP between two motions that its Table 4 does not allow in succession,
/// above all for a change of direction (DS-S 4.1, 4.2). The procedure stops smoothly, waits until two
/// statuses report standstill at the same position, and starts the new motion. A relative goal is relative to
/// that position. Where the axis has backlash to take up, the motion first goes beyond its goal, as from
/// standstill (approach.h).
class ChangeMotion : public Procedure {
public:
    ChangeMotion(ModuleIndex module, StepperMotion motion)
        : Procedure(module, ProcedureKind::ChangeMotion), m_motion(motion) {}

private:
    /// Slowing down from speed 250 with the longest acceleration time takes 15.9 s (DS-S 4.2).
    static constexpr Duration kStopLimit = std::chrono::seconds(20);

    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next stop(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next waitForStandstill(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next go(const ModuleState& module);

    StepperMotion m_motion;
    TimePoint m_began;
    std::optional<TimePoint> m_stoppedAt;  ///< time of the last status before the stop was confirmed
    std::optional<TimePoint> m_stoodAt;    ///< time of the first status that reports standstill
    std::optional<std::int32_t> m_stoodPosition;
    std::optional<std::int64_t> m_turn;  ///< where the move under way ends that takes up the backlash
};

}  // namespace nmc
