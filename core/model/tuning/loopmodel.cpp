// SPDX-License-Identifier: MIT
#include "model/tuning/loopmodel.h"

#include <algorithm>
#include <cmath>

#include "base/time.h"

namespace nmc {

namespace {

[[nodiscard]] double signOf(double x) {
    return x < 0 ? -1.0 : 1.0;
}

}  // namespace

MotorMotion moved(const MotorConstants& motor, const MotorMotion& from, double pwm, double seconds) {
    const double drive = pwm + motor.load;
    MotorMotion now = from;
    // A part of the time for each direction: before a turn round, and after it.
    while (seconds > 0) {
        if (now.velocity == 0 && std::abs(drive) <= motor.friction)
            return now;
        const double direction = signOf(now.velocity == 0 ? drive : now.velocity);
        const double final = motor.gain * (drive - direction * motor.friction);
        const double excess = now.velocity - final;
        const bool turns = now.velocity * final < 0;
        const double untilRest = turns ? motor.timeConstant * std::log1p(-now.velocity / final) : seconds;
        const double part = std::min(seconds, untilRest);
        const double gone = -std::expm1(-part / motor.timeConstant);
        now.position += final * part + motor.timeConstant * excess * gone;
        now.velocity -= excess * gone;
        if (turns && untilRest <= seconds)
            now.velocity = 0;
        seconds -= part;
    }
    return now;
}

double servoTickOf(const servo::SetGain& gains) {
    return std::max<int>(gains.sr, 1) * toSeconds(kServoTick);
}

ControlFilter::ControlFilter(const servo::SetGain& gains, Rounding rounding, double integral, double error)
    : m_gains(gains), m_rounding(rounding), m_sum(integral * 256), m_errorBefore(error) {}

double ControlFilter::integral() const {
    return m_rounding == Rounding::Chip ? std::trunc(m_sum / 256) : m_sum / 256;
}

double ControlFilter::output(double error) {
    const double limit = 256.0 * m_gains.il;
    m_sum = std::clamp(m_sum + error, -limit, limit);
    const double change = error - m_errorBefore;
    m_errorBefore = error;
    const double steady = m_gains.kp * error + m_gains.ki * integral();
    // The encoder tells one of two whole numbers, one of them more often: equal where it is one already.
    const double fewer = std::floor(change);
    const double share = change - fewer;
    return (1 - share) * toAmplifier(steady + m_gains.kd * fewer) +
           (share > 0 ? share * toAmplifier(steady + m_gains.kd * (fewer + 1)) : 0.0);
}

double ControlFilter::standing() const {
    return toAmplifier(m_gains.kp * m_errorBefore + m_gains.ki * integral());
}

double ControlFilter::toAmplifier(double sum) const {
    const double wanted = std::abs(sum) / 256;
    // What is cut off is half a PWM count on average.
    const double whole = m_rounding == Rounding::Chip ? std::trunc(wanted) : std::max(0.0, wanted - 0.5);
    const double limited = std::min<double>(whole, m_gains.ol);
    const double added = m_gains.db.value_or(0) * std::min(1.0, whole);
    const double magnitude = std::min(limited + added, 255.0);
    return sum < 0 ? -magnitude : magnitude;
}

Loop::Loop(const MotorConstants& motor, const servo::SetGain& gains, const LoopStart& start, double goal,
           Rounding rounding)
    : m_motor(motor),
      m_rounding(rounding),
      m_tick(servoTickOf(gains)),
      m_goal(goal),
      m_filter(gains, rounding, start.integral, start.command - reading(start.position)),
      m_motion{start.position, 0.0} {
    const double ticks = std::clamp(motor.delay / m_tick, 0.0, double{kLongestDelay});
    m_wholeDelay = static_cast<std::size_t>(ticks);
    m_ownDelay = (ticks - static_cast<double>(m_wholeDelay)) * m_tick;
    m_sent.fill(m_filter.standing());
}

MotorMotion Loop::at(double seconds) {
    if (seconds < 0)
        return m_motion;
    while (m_nextTick <= seconds) {
        if (m_nextTick > 0)
            m_motion = after(m_tick);
        std::move_backward(m_sent.begin(), m_sent.end() - 1, m_sent.end());
        m_sent.front() = m_filter.output(m_goal - reading(m_motion.position));
        m_lastTick = m_nextTick;
        m_nextTick += m_tick;
    }
    return after(seconds - m_lastTick);
}

double Loop::reading(double position) const {
    return m_rounding == Rounding::Chip ? std::floor(position) : position;
}

/// Since the last tick. The torque of the one before it lasts as long as the delay.
MotorMotion Loop::after(double seconds) const {
    const double before = std::min(seconds, m_ownDelay);
    const MotorMotion then = moved(m_motor, m_motion, m_sent[m_wholeDelay + 1], before);
    return moved(m_motor, then, m_sent[m_wholeDelay], seconds - before);
}

}  // namespace nmc
