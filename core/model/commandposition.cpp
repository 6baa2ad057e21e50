// SPDX-License-Identifier: MIT
#include "model/commandposition.h"

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
    if (velocity <= 0.0 || acceleration <= 0.0) {  // the chip would never get going
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

double ProfileCurve::position(double s) const {
    if (s <= 0.0)
        return m_from;
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

void CommandPosition::apply(const bus::CommandExecuted& executed) {
    const auto* command = std::get_if<ServoCommand>(&executed.command);
    if (command == nullptr)
        return;
    if (const auto* trajectory = std::get_if<servo::LoadTrajectory>(command)) {
        load(*trajectory);
        if (trajectory->startNow)
            start(executed.time);
    } else if (std::holds_alternative<StartMotion>(*command)) {
        start(executed.time);
    } else if (const auto* stopMotor = std::get_if<servo::StopMotor>(command)) {
        stop(*stopMotor, executed.time);
    } else if (std::holds_alternative<ResetPosition>(*command)) {
        zero(executed.time);
    } else if (const auto* gains = std::get_if<servo::SetGain>(command)) {
        setTick(toSeconds(kServoTick) * gains->sr, executed.time);
    } else if (const auto* homing = std::get_if<servo::SetHoming>(command)) {
        m_homingStops = homing->motorOff || homing->stopAbruptly || homing->stopSmoothly;
    }
}

void CommandPosition::apply(const bus::Sample& sample) {
    const servo::StatusByte status = sample.report.servoStatus();
    if (sample.report.aux)
        m_servoOn = servo::AuxByte{*sample.report.aux}.servoOn();
    if (!m_servoOn) {
        m_curve.reset();
        m_awaiting = Awaiting::Nothing;
        return;
    }
    if (m_homingStops && !status.homeInProgress()) {
        m_homingStops = false;
        forget();
    }
    if (m_awaiting == Awaiting::HeldPosition && sample.report.position)
        begin(sample.time, ProfileCurve::rest(*sample.report.position));
    else if (m_awaiting == Awaiting::EndOfMove && status.moveDone())
        begin(sample.time, ProfileCurve::rest(m_goal));
}

void CommandPosition::forget() {
    m_curve.reset();
    m_awaiting = Awaiting::Nothing;
}

std::optional<double> CommandPosition::at(TimePoint time) const {
    if (!m_curve)
        return std::nullopt;
    return m_curve->position(secondsAt(time));
}

void CommandPosition::load(const servo::LoadTrajectory& load) {
    m_loaded = load;
    if (load.position)
        m_goal = load.position->value();
    if (load.velocity)
        m_velocity = load.velocity->value() / 65'536.0;
    if (load.acceleration)
        m_acceleration = load.acceleration->value() / 65'536.0;
}

void CommandPosition::start(TimePoint time) {
    if (!m_loaded.servo) {
        forget();
        m_servoOn = false;
        return;
    }
    m_servoOn = true;
    if (m_loaded.profile == servo::ProfileMode::Velocity) {
        changeVelocity(time, m_loaded.reverse ? -m_velocity : m_velocity);
        return;
    }
    if (const auto from = at(time))
        begin(effective(time), ProfileCurve::trapezoid(*from, m_goal, perSecond(m_velocity),
                                                       perSecond(perSecond(m_acceleration))));
    else
        m_awaiting = Awaiting::EndOfMove;
}

void CommandPosition::changeVelocity(TimePoint time, double goal) {
    if (!m_curve)
        return;
    const TimePoint start = effective(time);
    const double s = secondsAt(start);
    begin(start, ProfileCurve::velocityChange(m_curve->position(s), m_curve->velocity(s), perSecond(goal),
                                              perSecond(perSecond(m_acceleration))));
}

TimePoint CommandPosition::effective(TimePoint time) const {
    return time - fromSeconds(0.5 * (m_tick - toSeconds(kServoTick)));
}

void CommandPosition::stop(const servo::StopMotor& stop, TimePoint time) {
    const auto from = at(time);
    switch (stop.manner) {
        case servo::StopManner::AmplifierOnly:
            return;
        case servo::StopManner::MotorOff:
            forget();
            m_servoOn = false;
            break;
        case servo::StopManner::Abruptly:
            if (from)
                begin(time, ProfileCurve::rest(*from));
            else if (!m_servoOn)
                m_awaiting = Awaiting::HeldPosition;
            m_servoOn = true;
            break;
        case servo::StopManner::Smoothly:
            changeVelocity(time, 0.0);
            break;
        case servo::StopManner::Here:
            begin(time, ProfileCurve::rest(stop.here.value()));
            m_servoOn = true;
            break;
    }
    m_velocity = 0.0;  // the chip zeroes its velocity parameter (protocol.md 2)
}

void CommandPosition::zero(TimePoint time) {
    if (!m_curve)
        return;
    const double s = secondsAt(time);
    const double velocity = m_curve->velocity(s);
    const double goal = m_curve->goalVelocity();
    begin(time, ProfileCurve::velocityChange(0.0, velocity, goal, perSecond(perSecond(m_acceleration))));
}

void CommandPosition::setTick(double seconds, TimePoint time) {
    const double factor = seconds / m_tick;
    m_tick = seconds;
    if (!m_curve || factor == 1.0)
        return;
    // The chip counts per tick, so a longer tick runs the same profile more slowly from here on.
    m_curve = m_curve->stretched(factor);
    m_started = time - fromSeconds(secondsAt(time) * factor);
}

void CommandPosition::begin(TimePoint time, ProfileCurve curve) {
    m_curve = curve;
    m_started = time;
    m_awaiting = Awaiting::Nothing;
}

}  // namespace nmc
