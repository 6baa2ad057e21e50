// SPDX-License-Identifier: MIT
#include "model/commandposition.h"

namespace nmc {

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
