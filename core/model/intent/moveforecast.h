// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/motion.h"

namespace nmc {

/// The predicted duration and peak velocity of a trapezoidal move from standstill (DS-V 4.4).
struct MoveForecast {
    double seconds = 0.0;
    double peakVelocity = 0.0;  ///< native
    bool triangular = false;    ///< too short to reach its velocity
    double accelerating = 0.0;  ///< s, from standstill to the peak
};

/// `distance` in counts, of either sign; velocity and acceleration native and above 0, `perSecond` as in
/// AxisScale. Pure.
[[nodiscard]] MoveForecast forecast(double distance, double velocity, double acceleration, double perSecond);
/// The same for a PIC-SERVO; `servoRate` is its SR, which multiplies the length of a tick.
[[nodiscard]] MoveForecast forecast(double distance, const ServoPace& pace, int servoRate);

}  // namespace nmc
