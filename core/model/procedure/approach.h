// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "bus/standstill.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// A move to a goal where the axis has backlash: beyond it first, then to it from the side that the axis
/// wants (model/intent/backlash.h). Two moves of the same kind, the second one from standstill. Any stop ends
/// it.
class Approach : public Procedure {
public:
    /// `wanted` is possible now, and has to turn round at `turn`.
    using Wanted = std::variant<intent::GoTo, stepintent::Move>;
    Approach(const Wanted& wanted, std::int32_t turn, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Step> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next go(ProcedureStage stage, std::int32_t goal, const ModuleState& module);
    /// The same move to another goal.
    [[nodiscard]] Intent moveTo(std::int32_t goal) const;

    Wanted m_wanted;
    std::int32_t m_end;
    std::int32_t m_turn;
    std::int32_t m_goal = 0;  ///< of the move under way
    bool m_started = false;
    TimePoint m_startedAt;
    Standstill m_standstill;
};

}  // namespace nmc
