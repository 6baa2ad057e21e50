// SPDX-License-Identifier: MIT
#include "model/module/pwmdemand.h"

#include <algorithm>
#include <cmath>

namespace nmc {

PwmDemand pwmDemand(const servo::SetGain& gains, double errorBefore, double error) {
    const double filter = std::abs(gains.kp * error + gains.kd * (error - errorBefore));
    const double integral = static_cast<double>(gains.ki) * gains.il;
    const double wanted = std::max(0.0, filter - integral) / 256;
    return {static_cast<int>(wanted), gains.ol};
}

}  // namespace nmc
