// SPDX-License-Identifier: MIT
#include "model/scope/profilecurve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmc {

ProfileCurve ProfileCurve::rest(double position) {
    ProfileCurve curve;
    curve.m_from = position;
    return curve;
}

ProfileCurve ProfileCurve::trapezoid(double from, double goal, double velocity, double acceleration) {
    ProfileCurve curve = rest(from);
    const double distance = std::abs(goal - from);
    const double sign = goal < from ? -1.0 : 1.0;
    if (distance == 0.0)
        return curve;
    if (velocity <= 0.0 || acceleration <= 0.0) {  // the chip would never start moving
        curve.m_slewTime = std::numeric_limits<double>::infinity();
        return curve;
    }
    const double peak = std::min(velocity, std::sqrt(distance * acceleration));
    curve.m_accelTime = curve.m_decelTime = peak / acceleration;
    curve.m_slewTime = std::max(0.0, distance / peak - curve.m_accelTime);
    curve.m_accel = sign * acceleration;
    curve.m_decel = -curve.m_accel;
    curve.m_goal = goal;
    return curve;
}

ProfileCurve ProfileCurve::velocityChange(double from, double velocity, double goalVelocity,
                                          double acceleration) {
    ProfileCurve curve = rest(from);
    curve.m_startVelocity = velocity;
    curve.m_endVelocity = goalVelocity;
    const double change = goalVelocity - velocity;
    if (change == 0.0)
        return curve;
    if (acceleration <= 0.0) {
        curve.m_accelTime = std::numeric_limits<double>::infinity();
        return curve;
    }
    curve.m_accelTime = std::abs(change) / acceleration;
    curve.m_accel = std::copysign(acceleration, change);
    return curve;
}

ProfileCurve ProfileCurve::stretched(double factor) const {
    ProfileCurve curve = *this;
    curve.m_startVelocity /= factor;
    curve.m_endVelocity /= factor;
    curve.m_accelTime *= factor;
    curve.m_slewTime *= factor;
    curve.m_decelTime *= factor;
    curve.m_accel /= factor * factor;
    curve.m_decel /= factor * factor;
    return curve;
}

ProfileCurve ProfileCurve::shifted(double counts) const {
    ProfileCurve curve = *this;
    curve.m_from += counts;
    return curve;
}

double ProfileCurve::endOf(Phase phase) const {
    switch (phase) {
        case Phase::Acceleration:
            return m_accelTime;
        case Phase::Slew:
            return m_accelTime + m_slewTime;
        case Phase::Last:
            break;
    }
    return m_accelTime + m_slewTime + m_decelTime;
}

ProfileCurve::Range ProfileCurve::range(double from, double to) const {
    const auto [low, high] = std::minmax({position(from), position(to)});
    Range range{low, high};
    // The motion reverses at most once, during the acceleration.
    const double turn = m_accel != 0.0 ? -m_startVelocity / m_accel : 0.0;
    if (turn > std::max(0.0, from) && turn < std::min(m_accelTime, to)) {
        range.low = std::min(range.low, position(turn));
        range.high = std::max(range.high, position(turn));
    }
    return range;
}

double ProfileCurve::position(double s) const {
    if (s <= 0.0)
        return m_from + m_startVelocity * s;
    if (m_goal && s >= duration())
        return *m_goal;
    const double accelerating = std::min(s, m_accelTime);
    double position = m_from + m_startVelocity * accelerating + 0.5 * m_accel * accelerating * accelerating;
    const double slewVelocity = m_startVelocity + m_accel * accelerating;
    const double afterAccel = s - accelerating;
    if (!m_goal)
        return position + slewVelocity * afterAccel;
    const double slewing = std::min(afterAccel, m_slewTime);
    const double decelerating = afterAccel - slewing;
    position += slewVelocity * (slewing + decelerating) + 0.5 * m_decel * decelerating * decelerating;
    return position;
}

double ProfileCurve::velocity(double s) const {
    if (s >= duration())
        return m_endVelocity;
    if (s <= 0.0)
        return m_startVelocity;
    const double decelerating = std::max(0.0, s - m_accelTime - m_slewTime);
    return m_startVelocity + m_accel * std::min(s, m_accelTime) + m_decel * decelerating;
}

}  // namespace nmc
