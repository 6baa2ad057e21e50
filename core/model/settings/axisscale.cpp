// SPDX-License-Identifier: MIT
#include "model/settings/axisscale.h"

#include <algorithm>

#include "base/time.h"

namespace nmc {

std::string symbolOf(const AxisUnit& unit, bool steps) {
    switch (unit.kind) {
        case UnitKind::Native:
            return steps ? "steps" : "counts";
        case UnitKind::Turns:
            return "turns";
        case UnitKind::Degrees:
            return "deg";
        case UnitKind::Millimetres:
            return "mm";
        case UnitKind::Own:
            break;
    }
    return unit.ownSymbol.empty() ? "units" : unit.ownSymbol;
}

AxisScale::AxisScale(AxisUnit unit, std::optional<double> perSecond, bool steps)
    : m_unit(std::move(unit)), m_perSecond(perSecond), m_steps(steps) {}

AxisScale AxisScale::servo(AxisUnit unit, std::optional<int> servoRate) {
    return {std::move(unit), servoRate ? std::optional(ticksPerSecond(*servoRate)) : std::nullopt, false};
}

AxisScale AxisScale::step(AxisUnit unit) {
    return {std::move(unit), 1.0, true};
}

std::optional<double> AxisScale::velocity(double nativeVelocity) const {
    if (native())
        return nativeVelocity;
    return m_perSecond ? std::optional(distance(nativeVelocity * *m_perSecond)) : std::nullopt;
}

std::optional<double> AxisScale::nativeVelocity(double velocity) const {
    if (native())
        return velocity;
    return m_perSecond ? std::optional(countsOfDistance(velocity) / *m_perSecond) : std::nullopt;
}

std::optional<double> AxisScale::acceleration(double nativeAcceleration) const {
    if (native())
        return nativeAcceleration;
    return m_perSecond ? std::optional(distance(nativeAcceleration * *m_perSecond * *m_perSecond))
                       : std::nullopt;
}

std::optional<double> AxisScale::nativeAcceleration(double acceleration) const {
    if (native())
        return acceleration;
    return m_perSecond ? std::optional(countsOfDistance(acceleration) / (*m_perSecond * *m_perSecond))
                       : std::nullopt;
}

std::string velocitySymbolOf(const AxisScale& scale, bool steps) {
    return symbolOf(scale.unit(), steps) + (scale.native() && !scale.steps() ? "/tick" : "/s");
}

std::optional<double> countsPerTurn(const AxisUnit& unit) {
    constexpr double kDegreesPerTurn = 360.0;
    switch (unit.kind) {
        case UnitKind::Turns:
            return std::abs(unit.countsPerUnit);
        case UnitKind::Degrees:
            return std::abs(unit.countsPerUnit) * kDegreesPerTurn;
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
    /// Farther away it is not at home, whatever the scale.
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
            counts = std::abs(unit.countsPerUnit) * kMillimetres;
            break;
        case UnitKind::Own:
            counts = std::abs(unit.countsPerUnit) * kPart;
            break;
    }
    return static_cast<std::int32_t>(std::floor(std::clamp(counts, 1.0, kMax)));
}

}  // namespace nmc
