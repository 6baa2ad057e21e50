// SPDX-License-Identifier: MIT
#include "sim/pid.h"

#include <algorithm>

namespace nmc::sim {

std::int64_t PidFilter::output(const Gains& gains, std::int32_t error) {
    const std::int32_t limit = std::int32_t{gains.il} * 256;
    // The sum is limited before it is used, so that an IL of 0 empties it at once (DS-V 4.3).
    m_runningSum = std::clamp(m_runningSum + error, -limit, limit);
    const std::int64_t change = std::int64_t{error} - m_previousError;
    m_previousError = error;
    return std::int64_t{gains.kp} * error + std::int64_t{gains.kd} * change +
           std::int64_t{gains.ki} * (m_runningSum / 256);
}

}  // namespace nmc::sim
