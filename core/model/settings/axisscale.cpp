// SPDX-License-Identifier: MIT
#include "model/settings/axisscale.h"

#include <algorithm>
#include <utility>

#include "base/time.h"

namespace nmc {

AxisScale::AxisScale(AxisUnit unit, double perSecond, bool steps)
    : m_unit(std::move(unit)), m_perSecond(perSecond), m_steps(steps) {}

AxisScale AxisScale::servo(AxisUnit unit, int servoRate) {
    return {std::move(unit), 1.0 / (toSeconds(kServoTick) * std::max(1, servoRate)), false};
}

AxisScale AxisScale::step(AxisUnit unit) {
    return {std::move(unit), 1.0, true};
}

double AxisScale::velocity(double nativeVelocity) const {
    return native() ? nativeVelocity : nativeVelocity * m_perSecond / countsPerUnit();
}

double AxisScale::nativeVelocity(double velocity) const {
    return native() ? velocity : velocity * countsPerUnit() / m_perSecond;
}

double AxisScale::acceleration(double nativeAcceleration) const {
    return native() ? nativeAcceleration : nativeAcceleration * m_perSecond * m_perSecond / countsPerUnit();
}

double AxisScale::nativeAcceleration(double acceleration) const {
    return native() ? acceleration : acceleration * countsPerUnit() / (m_perSecond * m_perSecond);
}

}  // namespace nmc
