// SPDX-License-Identifier: MIT
#include "model/settings/axisscale.h"

#include <algorithm>
#include <cmath>
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

std::optional<double> countsPerTurn(const AxisUnit& unit) {
    constexpr double kDegreesPerTurn = 360.0;
    switch (unit.kind) {
        case UnitKind::Turns:
            return unit.countsPerUnit;
        case UnitKind::Degrees:
            return unit.countsPerUnit * kDegreesPerTurn;
        case UnitKind::Native:
        case UnitKind::Millimetres:
        case UnitKind::Own:
            break;
    }
    return std::nullopt;
}

std::int32_t homeTolerance(const AxisUnit& unit) {
    constexpr double kPart = 1e-3;
    constexpr double kMillimetres = 0.01;
    /// Beyond that it is not at home, whatever the scale.
    constexpr double kMax = 1'000.0;
    double counts = 1.0;
    switch (unit.kind) {
        case UnitKind::Native:
            break;
        case UnitKind::Turns:
        case UnitKind::Degrees:
            counts = *countsPerTurn(unit) * kPart;
            break;
        case UnitKind::Millimetres:
            counts = unit.countsPerUnit * kMillimetres;
            break;
        case UnitKind::Own:
            counts = unit.countsPerUnit * kPart;
            break;
    }
    return static_cast<std::int32_t>(std::floor(std::clamp(counts, 1.0, kMax)));
}

}  // namespace nmc
