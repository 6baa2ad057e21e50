// SPDX-License-Identifier: MIT
#include "model/intent/moveforecast.h"

#include <cmath>

namespace nmc {

MoveForecast forecast(double distance, double velocity, double acceleration, double perSecond) {
    const double way = std::abs(distance);
    // Speeding up and slowing down take v^2 / 2a each.
    const bool triangular = way < velocity * velocity / acceleration;
    const double peak = triangular ? std::sqrt(way * acceleration) : velocity;
    if (peak == 0.0)
        return {};
    const double ticks = triangular ? 2.0 * peak / acceleration : way / velocity + velocity / acceleration;
    return {ticks / perSecond, peak, triangular};
}

}  // namespace nmc
