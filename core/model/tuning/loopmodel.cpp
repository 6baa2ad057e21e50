// SPDX-License-Identifier: MIT
#include "model/tuning/loopmodel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/time.h"

namespace nmc {

namespace {

[[nodiscard]] double signOf(double x) {
    return x < 0 ? -1.0 : 1.0;
}

/// The mean magnitude left of a number when its fractional part is cut off.
[[nodiscard]] double meanOfWhole(double x) {
    return std::copysign(std::max(0.0, std::abs(x) - 0.5), x);
}

}  // namespace

HoldingRange holdingRange(const MotorConstants& motor) {
    // Made continuous where the deadband changes sides, over the width of a count.
    const auto before = [&](double drive) { return drive + motor.deadband * std::clamp(drive, -1.0, 1.0); };
    return {before(-motor.load - motor.friction), before(-motor.load + motor.friction)};
}

MotorMotion moved(const MotorConstants& motor, const MotorMotion& from, double pwm, double seconds) {
    const double drive = pwm + motor.load;
    MotorMotion now = from;
    // The time is divided at a reversal, because friction depends on the direction.
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

ControlFilter::ControlFilter(const servo::SetGain& gains, Rounding rounding, double integral, double error,
                             double deadband)
    : m_gains(gains),
      m_rounding(rounding),
      m_deadband(deadband),
      m_sum(integral * 256),
      m_errorBefore(error) {}

double ControlFilter::integral() const {
    const double exact = m_sum / 256;
    return m_rounding == Rounding::Chip ? std::trunc(exact) : meanOfWhole(exact);
}

double ControlFilter::output(double error) {
    const double limit = 256.0 * m_gains.il;
    m_sum = std::clamp(m_sum + error, -limit, limit);
    const double change = error - m_errorBefore;
    m_errorBefore = error;
    const double steady = m_gains.kp * error + m_gains.ki * integral();
    // On average the encoder reports one of two adjacent whole numbers, with shares that give the mean; a
    // whole number is reported as it is.
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
    const double whole = m_rounding == Rounding::Chip ? std::trunc(wanted) : meanOfWhole(wanted);
    const double limited = std::min<double>(whole, m_gains.ol);
    const double added = m_gains.db.value_or(0) * std::min(1.0, whole);
    const double magnitude = std::max(0.0, std::min(limited + added, 255.0) - m_deadband);
    return sum < 0 ? -magnitude : magnitude;
}

Loop::Loop(const MotorConstants& motor, const servo::SetGain& gains, const LoopStart& start, double goal,
           Rounding rounding)
    : m_motor(motor),
      m_rounding(rounding),
      m_tick(secondsPerTick(gains.sr)),
      m_goal(goal),
      m_filter(gains, rounding, start.integral, start.command - reading(start.position), motor.deadband),
      m_state{{start.position + start.slack * motor.play, 0.0}},
      m_driven(start.position) {
    const double ticks = std::clamp(motor.delay / m_tick, 0.0, double{kLongestDelay});
    m_wholeDelay = static_cast<std::size_t>(ticks);
    m_ownDelay = (ticks - static_cast<double>(m_wholeDelay)) * m_tick;
    m_sent.fill(m_filter.standing());
}

MotorMotion Loop::at(double seconds) {
    if (seconds < 0)
        return {m_driven, m_state.shaft.velocity};
    while (m_nextTick <= seconds) {
        if (m_nextTick > 0) {
            m_state = after(m_tick);
            m_driven = driven(m_state.shaft.position);
        }
        std::move_backward(m_sent.begin(), m_sent.end() - 1, m_sent.end());
        m_sent.front() = m_filter.output(m_goal - noisyReading());
        m_lastTick = m_nextTick;
        m_nextTick += m_tick;
    }
    const MotorMotion shaft = after(seconds - m_lastTick).shaft;
    return {driven(shaft.position), shaft.velocity};
}

/// The encoder reading that the filter receives.
double Loop::noisyReading() {
    const double reading = this->reading(m_driven);
    return m_motor.noise > 0 && m_rounding == Rounding::Chip
               ? reading + std::round(m_motor.noise * m_noise(m_random))
               : reading;
}

double Loop::driven(double shaft) const {
    return std::clamp(m_driven, shaft - m_motor.play, shaft);
}

double Loop::reading(double position) const {
    return m_rounding == Rounding::Chip ? std::floor(position) : position;
}

/// The state `seconds` after the last tick. The torque of the tick before remains in effect for the duration
/// of the delay.
Loop::State Loop::after(double seconds) const {
    const double before = std::min(seconds, m_ownDelay);
    State state = m_state;
    go(state, m_sent[m_wholeDelay + 1], before);
    go(state, m_sent[m_wholeDelay], seconds - before);
    return state;
}

void Loop::go(State& state, double pwm, double seconds) const {
    if (m_motor.second == 0) {
        state.shaft = moved(m_motor, state.shaft, pwm, seconds);
        return;
    }
    constexpr double kStep = 128e-6;  // s, one leapfrog step
    constexpr double kRest = 1e-9;
    MotorConstants shaft = m_motor;  // the shaft without the second mass
    const double total = 1 + m_motor.second;
    shaft.timeConstant /= total;
    const double omega = 2 * std::numbers::pi * m_motor.resonance;
    while (seconds > kRest) {
        const double step = std::min(seconds, kStep);
        state.twist += step / 2 * (state.shaft.velocity - state.second);
        // The acceleration with which the two approach each other.
        const double pull =
            omega * omega * state.twist + 2 * kSpringDamping * omega * (state.shaft.velocity - state.second);
        shaft.load = m_motor.load - pull * m_motor.second / total * shaft.timeConstant / shaft.gain;
        state.shaft = moved(shaft, state.shaft, pwm, step);
        state.second += step * pull / total;
        state.twist += step / 2 * (state.shaft.velocity - state.second);
        seconds -= step;
    }
}

}  // namespace nmc
