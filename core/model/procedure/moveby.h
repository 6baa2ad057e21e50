// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/procedure/goalmoves.h"

namespace nmc {

/// Trapezoidal moves by N counts, each from the goal of the previous move, so that the errors of a servo do
/// not add up. On an axis with backlash, each move first turns round beyond its goal
/// (model/intent/backlash.h).
class MoveByRun : public GoalMoves {
public:
    MoveByRun(const intent::MoveBy& wanted, const ModuleState& module);

private:
    [[nodiscard]] Intent moveTo(std::int32_t goal) const override;
    [[nodiscard]] Next standing(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] Next nextMove(const ModuleState& module);

    Rounds m_moves;
    Pace m_pace;
    std::optional<std::int64_t> m_goal;  ///< goal of the last move
    unsigned m_made = 0;
    TimePoint m_pausedAt;
};

}  // namespace nmc
