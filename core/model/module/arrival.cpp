// SPDX-License-Identifier: MIT
#include "model/module/arrival.h"

#include <cmath>

namespace nmc {

Arrival::State Arrival::look(const ModuleState& module, std::int32_t goal, const ArrivalSettings& axis) {
    const TimePoint now = module.latestTime;
    const std::int32_t position = *module.latest->position;
    if (axis.tolerance <= 0.0 || !module.isServo())
        return m_standstill.look(now, position, module.moving()) ? State::There : State::Underway;
    if (module.moving()) {
        m_ended.reset();
        m_within.reset();
        return State::Underway;
    }
    m_ended = m_ended.value_or(now);
    if (std::abs(1.0 * countsBetween(goal, position)) > axis.tolerance)
        m_within.reset();
    else
        m_within = m_within.value_or(now);
    const Duration needed = fromSeconds(axis.seconds);
    if (m_within && now - *m_within >= needed)
        return State::There;
    return now - *m_ended > needed + kPatience ? State::Missed : State::Underway;
}

}  // namespace nmc
