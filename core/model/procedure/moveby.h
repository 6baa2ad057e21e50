// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "model/procedure/goalmoves.h"

namespace nmc {

/// Trapezoidal moves by N counts, from where the last move was to go: what a servo is off by does not add up.
/// Each turns round beyond its goal first where the axis has backlash (model/intent/backlash.h).
class MoveByRun : public GoalMoves {
public:
    using Wanted = std::variant<intent::MoveBy, stepperintent::MoveBy>;
    MoveByRun(const Wanted& wanted, const ModuleState& module);

private:
    [[nodiscard]] Intent moveTo(std::int32_t goal) const override;
    [[nodiscard]] Next standing(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next nextMove(const ModuleState& module);

    Wanted m_wanted;
    Rounds m_moves;
    std::optional<std::int64_t> m_goal;  ///< of the last move
    unsigned m_made = 0;
    TimePoint m_pausedAt;
};

}  // namespace nmc
