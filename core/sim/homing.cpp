// SPDX-License-Identifier: MIT
#include "sim/homing.h"

namespace nmc::sim {

void Homing::begin(std::uint8_t control, HomeInputs now) {
    constexpr unsigned kConditions = kLimit1 | kLimit2 | kIndex | kPositionError | kCurrentLimit;
    m_control = control;
    m_baseline = now;
    m_inProgress = (control & kConditions) != 0;
}

bool Homing::triggered(HomeInputs now, bool positionErrorTrip, bool currentLimiting) {
    const auto watches = [this](std::uint8_t bit) { return (m_control & bit) != 0; };
    const bool found = (watches(kLimit1) && now.limit1 != m_baseline.limit1) ||
                       (watches(kLimit2) && now.limit2 != m_baseline.limit2) ||
                       (watches(kIndex) && now.index != m_baseline.index) ||
                       (watches(kPositionError) && positionErrorTrip) ||
                       (watches(kCurrentLimit) && currentLimiting);
    if (found)
        m_inProgress = false;
    return found;
}

Homing::Stop Homing::stop() const {
    if ((m_control & kMotorOff) != 0)
        return Stop::Off;
    if ((m_control & kStopAbruptly) != 0)
        return Stop::Abrupt;
    return (m_control & kStopSmoothly) != 0 ? Stop::Smooth : Stop::None;
}

}  // namespace nmc::sim
