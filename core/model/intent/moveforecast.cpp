// SPDX-License-Identifier: MIT
#include "model/intent/moveforecast.h"

#include <cmath>

#include "base/time.h"

namespace nmc {

MoveForecast forecast(double distance, double velocity, double acceleration, double perSecond) {
    const double length = std::abs(distance);
    // Acceleration and deceleration take a distance of v^2 / 2a each.
    const bool triangular = length < velocity * velocity / acceleration;
    const double peak = triangular ? std::sqrt(length * acceleration) : velocity;
    if (peak == 0.0)
        return {};
    const double ticks = triangular ? 2.0 * peak / acceleration : length / velocity + velocity / acceleration;
    return {ticks / perSecond, peak, triangular, peak / acceleration / perSecond};
}

MoveForecast forecast(double distance, const ServoPace& pace, int servoRate) {
    return forecast(distance, toCounts(pace.velocity), toCounts(pace.acceleration),
                    ticksPerSecond(servoRate));
}

}  // namespace nmc
