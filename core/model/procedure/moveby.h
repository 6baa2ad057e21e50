// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "model/procedure/goalmoves.h"

namespace nmc {

/// Trapezoidal moves by N counts, each from the goal of the previous move, so that the errors of a servo do
/// not add up. On an axis with backlash, each move first turns round beyond its goal
/// (model/intent/backlash.h).
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
    std::optional<std::int64_t> m_goal;  ///< goal of the last move
    unsigned m_made = 0;
    TimePoint m_pausedAt;
};

}  // namespace nmc
