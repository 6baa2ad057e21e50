// SPDX-License-Identifier: MIT
#include "model/intent/directionplan.h"

#include <algorithm>
#include <cmath>

namespace nmc {

std::int32_t directionReach(const AxisUnit& unit) {
    constexpr double kPart = 8.0;
    constexpr double kCountsPerTurnUnknown = 2'000.0;
    /// Five times the distance that counts as motion, because with a gear one turn of the axis is many turns
    /// of the motor.
    constexpr double kMin = 5.0 * kMovedCounts;
    constexpr double kMax = 1'000.0;
    const double part = countsPerTurn(unit).value_or(kCountsPerTurnUnknown) / kPart;
    return static_cast<std::int32_t>(std::lround(std::clamp(part, kMin, kMax)));
}

}  // namespace nmc
