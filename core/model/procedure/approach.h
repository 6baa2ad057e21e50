// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "model/procedure/goalmoves.h"

namespace nmc {

/// A move to a goal where the axis has backlash: beyond it first, then to it from the side that the axis
/// wants (model/intent/backlash.h). Two moves of the same kind.
class Approach : public GoalMoves {
public:
    using Wanted = std::variant<intent::GoTo, stepperintent::Move>;
    /// `wanted` is possible now, and has to turn round at `turn`.
    Approach(const Wanted& wanted, std::int32_t turn, const ModuleState& module);

private:
    [[nodiscard]] Intent moveTo(std::int32_t goal) const override;
    [[nodiscard]] Next standing(const ModuleState& module, TimePoint now) override;

    Wanted m_wanted;
    std::int32_t m_end;
    std::int32_t m_turn;
};

}  // namespace nmc
