// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "bus/standstill.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Trapezoidal moves by N counts, from where the last move was to go: what a servo is off by does not add up.
/// Each waits for the one before to stand still, and turns round beyond its goal first where the axis has
/// backlash (model/intent/backlash.h). Any stop ends it.
class StepByRun : public Procedure {
public:
    using Wanted = std::variant<intent::StepBy, stepintent::StepBy>;
    StepByRun(const Wanted& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Step> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next move(const ModuleState& module);
    [[nodiscard]] Next go(std::int64_t goal, const ModuleState& module);
    [[nodiscard]] Next moving(const ModuleState& module, TimePoint now);

    /// One move of the chip's own kind.
    [[nodiscard]] Intent moveTo(std::int32_t goal) const;
    [[nodiscard]] Next arrived(const ModuleState& module, TimePoint now);

    Wanted m_wanted;
    Rounds m_moves;
    std::optional<std::int64_t> m_goal;  ///< of the last move
    std::int64_t m_heading = 0;          ///< where it goes now: there, or where it turns round
    unsigned m_made = 0;
    bool m_started = false;
    TimePoint m_startedAt;
    TimePoint m_pausedAt;
    Standstill m_standstill;
};

}  // namespace nmc
