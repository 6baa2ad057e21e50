// SPDX-License-Identifier: MIT
#include "model/scope/commandenvelope.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/strong.h"

namespace nmc {

namespace {

/// The maximum distance of the chip's steps from the curve that runs half a servo tick ahead of them. With
/// acceleration a, the N-th step is at a N(N+1)/2 and the curve at a (N + 1/2)^2 / 2, which is a/8 more. When
/// the velocity is reached within a tick, the distance is smaller: at most half a tick of the velocity
/// change.
double stepHeight(double change, double acceleration) {
    return std::min(acceleration / 8, std::abs(change) / 2);
}

/// The distance of the steps from the curve once the new velocity is reached, with `change` / `acceleration`
/// equal to M ticks and a fraction f: the steps are at a (M(M+1)/2 + M + f), and the curve is a f(1-f)/2
/// further.
double stepsBehind(double change, double acceleration) {
    if (acceleration <= 0.0)
        return 0.0;
    const double ticks = std::abs(change) / acceleration;
    const double fraction = ticks - std::floor(ticks);
    return std::copysign(acceleration * fraction * (1.0 - fraction) / 2, change);
}

}  // namespace

CommandEnvelope::CommandEnvelope(const CommandEstimate& held)
    : m_curves{Curve{ProfileCurve::rest(held.low), {}}, Curve{ProfileCurve::rest(held.position), {}},
               Curve{ProfileCurve::rest(held.high), {}}} {}

void CommandEnvelope::Curve::moveStart(Duration later) {
    // Until the later start, the motion continues unchanged.
    profile = profile.shifted(profile.velocity(0.0) * toSeconds(later));
    start += later;
}

ProfileCurve::Range CommandEnvelope::range(const Curve& curve, const Moments& when) const {
    const double earliest = curve.seconds(when.earliest);
    const double latest = curve.seconds(when.latest);
    ProfileCurve::Range range =
        curve.profile.range(earliest * (1.0 - when.apart), latest * (1.0 + when.apart));
    if (earliest < curve.profile.endOf(ProfileCurve::Phase::Last) + m_settling) {
        range.low -= m_steps;
        range.high += m_steps;
    }
    return {std::clamp(range.low, m_ends.low, m_ends.high), std::clamp(range.high, m_ends.low, m_ends.high)};
}

CommandEstimate CommandEnvelope::at(const Moments& when) const {
    const double low = range(m_curves[Low], when).low;
    const double high = std::max(low, range(m_curves[High], when).high);
    const Curve& likely = m_curves[Likely];
    return {std::clamp(likely.profile.position(likely.seconds(when.likely)), low, high), low, high};
}

TimePoint CommandEnvelope::pick(Side side, bool up, const Moments& when) {
    if (side == Likely)
        return when.likely;
    return (side == High) == up ? when.earliest : when.latest;
}

void CommandEnvelope::moveTo(double goal, double velocity, Pace pace, const Moments& when) {
    const double perSecond = 1.0 / pace.tick;
    m_ends = {std::min(goal, m_curves[Low].profile.position(0.0)),
              std::max(goal, m_curves[High].profile.position(0.0))};
    double ticks = 0;
    for (const Side side : {Low, Likely, High}) {
        const double from = m_curves[side].profile.position(0.0);
        const auto profile = ProfileCurve::trapezoid(from, goal, velocity * perSecond,
                                                     pace.acceleration * perSecond * perSecond);
        m_curves[side] = {profile, pick(side, goal > from, when)};
        ticks = std::max(ticks, profile.endOf(ProfileCurve::Phase::Last) * perSecond);
    }
    // While it slows down towards its goal, the chip rounds its velocity to 1/65536 count per tick (4.4).
    const double rounding = std::isfinite(ticks) ? ticks / kFixedPointOne : 0.0;
    m_steps = stepHeight(velocity, pace.acceleration) + rounding;
    m_settling = 2 * pace.tick;
}

void CommandEnvelope::changeVelocity(double velocity, Pace pace, const Moments& when) {
    m_curves = {changed(Low, velocity, pace, when), changed(Likely, velocity, pace, when),
                changed(High, velocity, pace, when)};
    m_steps = m_settling = 0.0;
    m_ends = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

CommandEnvelope::Curve CommandEnvelope::changed(const Curve& curve, Side side, double velocity, Pace pace,
                                                TimePoint start, double apart) const {
    const double perSecond = 1.0 / pace.tick;
    const double from = curve.profile.velocity(curve.seconds(start));
    const double change = velocity - from * pace.tick;
    double position = 0;
    if (side == Likely) {
        position = curve.profile.position(curve.seconds(start)) - stepsBehind(change, pace.acceleration);
    } else {
        const ProfileCurve::Range reached = range(curve, {start, start, start, apart});
        const double steps = stepHeight(change, pace.acceleration);
        position = side == Low ? reached.low - (change > 0.0 ? steps : 0.0)
                               : reached.high + (change < 0.0 ? steps : 0.0);
    }
    return {ProfileCurve::velocityChange(position, from, velocity * perSecond,
                                         pace.acceleration * perSecond * perSecond),
            start};
}

CommandEnvelope::Curve CommandEnvelope::changed(Side side, double velocity, Pace pace,
                                                const Moments& when) const {
    const Curve& curve = m_curves[side];
    if (side != Likely && m_settling > 0.0)
        return changedTrapezoid(side, velocity, pace, when);
    const bool up = velocity / pace.tick >= curve.profile.goalVelocity();
    return changed(curve, side, velocity, pace, pick(side, up, when), when.apart);
}

/// A trapezoid slows down during the time in which the change may occur, perhaps passing through the new
/// velocity. Neither the first moment nor the last then leads furthest, and of three curves to the same goal
/// the last one is the fastest, so all of them are tried.
CommandEnvelope::Curve CommandEnvelope::changedTrapezoid(Side side, double velocity, Pace pace,
                                                         const Moments& when) const {
    constexpr int kParts = 16;
    const double sign = side == High ? 1.0 : -1.0;
    std::vector<Curve> curves;
    TimePoint reached = when.latest;
    for (int i = 0; i <= kParts; ++i)
        for (const Curve& curve : m_curves) {
            curves.push_back(changed(curve, side, velocity, pace,
                                     when.earliest + (when.latest - when.earliest) * i / kParts, when.apart));
            if (const double ramp = curves.back().profile.duration(); std::isfinite(ramp))
                reached = std::max(reached, curves.back().start + fromSeconds(ramp));
        }
    const auto position = [sign](const Curve& curve, TimePoint time) {
        return sign * curve.profile.position(curve.seconds(time));
    };
    const auto furthest = [&](TimePoint time) {
        return *std::ranges::max_element(curves, {},
                                         [&](const Curve& curve) { return position(curve, time); });
    };
    Curve chosen = furthest(reached);
    const double missing = position(furthest(when.latest), when.latest) - position(chosen, when.latest);
    chosen.profile = chosen.profile.shifted(sign * missing);
    return chosen;
}

void CommandEnvelope::makeZero(Pace pace, const Moments& when) {
    const double perSecond = 1.0 / pace.tick;
    for (const Side side : {Low, Likely, High}) {
        Curve& curve = m_curves[side];
        const bool up = curve.profile.velocity(curve.seconds(when.likely)) > 0.0;
        const TimePoint start = pick(side, up, when);
        curve = {ProfileCurve::velocityChange(0.0, curve.profile.velocity(curve.seconds(start)),
                                              curve.profile.goalVelocity(),
                                              pace.acceleration * perSecond * perSecond),
                 start};
    }
    m_steps = m_settling = 0.0;
    m_ends = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

void CommandEnvelope::stretch(double factor, const Moments& before, const Moments& after) {
    for (const Side side : {Low, Likely, High}) {
        Curve& curve = m_curves[side];
        const bool up = curve.profile.velocity(curve.seconds(before.likely)) > 0.0;
        // Either as advanced as possible before the change and starting at the first moment after it, or the
        // opposite.
        const double s = curve.seconds(pick(side, !up, before));
        curve = {curve.profile.stretched(factor), pick(side, up, after) - fromSeconds(s * factor)};
    }
    m_settling *= factor;
}

bool CommandEnvelope::reported(ProfileCurve::Phase phase, int sign, TimePoint bound) {
    std::array<Duration, 3> off{};  // how far the phase ends on the wrong side of the bound
    for (const Side side : {Low, Likely, High}) {
        const double length = m_curves[side].profile.endOf(phase);
        if (!std::isfinite(length))
            return true;
        off[side] = sign * (m_curves[side].start + fromSeconds(length) - bound);
    }
    const auto [least, most] = std::ranges::minmax_element(off);
    const bool contradicts = *least > Duration{};
    for (const Side side : {Low, Likely, High})
        m_curves[side].moveStart(-sign * (contradicts ? *most : std::max(Duration{}, off[side])));
    return !contradicts;
}

}  // namespace nmc
