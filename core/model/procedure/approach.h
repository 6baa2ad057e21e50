// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/procedure/goalmoves.h"

namespace nmc {

/// A move to a goal on an axis with backlash: first beyond the goal, then to it from the side that the axis
/// requires (model/intent/backlash.h). Both moves are of the same kind.
class Approach : public GoalMoves {
public:
    /// `motion` must be possible now, and must turn round at `turn`.
    Approach(const MotionSpec& motion, std::int64_t turn, const ModuleState& module);

private:
    [[nodiscard]] Intent moveTo(std::int32_t goal) const override;
    [[nodiscard]] Next standing(const ModuleState& module, TimePoint now) override;

    MotionSpec m_motion;
    std::int32_t m_end;
    std::int64_t m_turn;  ///< possibly beyond the counter, which ends the procedure
};

}  // namespace nmc
