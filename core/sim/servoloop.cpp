// SPDX-License-Identifier: MIT
#include "sim/servoloop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace nmc::sim {

void ServoLoop::run(std::uint64_t ticks) {
    for (; ticks > 0 && !m_quiet; --ticks)
        tick();
}

void ServoLoop::tick() {
    m_plant.advanceTick(static_cast<double>(m_pwm) / pwmSteps(), m_ampEnabled && isPowered());
    m_encoderShaft = std::clamp(m_encoderShaft, m_plant.shaft() - motor().playCounts, m_plant.shaft());
    m_load = std::clamp(m_load, m_encoderShaft - motor().loadPlayCounts, m_encoderShaft);
    m_encoder.read(m_encoderShaft + encoderNoise());
    m_tripped = false;
    limitCurrent();
    if (undervoltage() && (m_servoOn || m_magnitude != 0))
        fault();
    if (protectsLimits())
        protectLimits();
    if (--m_ticksToServoTick <= 0) {
        m_ticksToServoTick = ticksPerServoTick();
        servoTick();
    }
    driveMotor();
    if (m_homing.inProgress())
        watchHome();
    m_quiet = !m_servoOn && m_pwm == 0 && m_velocity == 0 && m_adjustment == 0 && !m_limiting &&
              m_pulses == 0 && motor().encoderNoiseCounts == 0.0 &&
              m_lastServoPosition == m_encoder.position() && m_plant.atRest();
}

std::int64_t ServoLoop::encoderNoise() {
    const double rms = motor().encoderNoiseCounts;
    return rms == 0.0 ? 0 : std::llround(rms * m_noise.normal());
}

void ServoLoop::servoTick() {
    const std::int32_t position = m_encoder.position();
    m_velocity = static_cast<std::int32_t>(static_cast<std::uint32_t>(position) -
                                           static_cast<std::uint32_t>(m_lastServoPosition));
    m_lastServoPosition = position;
    if (!m_servoOn) {
        m_profile.follow(position, m_velocity);
        m_pulses = 0;
        return;
    }
    stepProfile();
    const std::int32_t error = positionError();
    if (std::abs(std::int64_t{error}) > m_gains.el) {
        fault();
        m_tripped = true;
        return;
    }
    const std::int64_t output = m_filter.output(m_gains, error);
    setOutput(std::min<std::int64_t>(std::abs(output) * pwmSteps() / 256, m_gains.ol * pwmSteps()),
              output < 0);
}

void ServoLoop::stepProfile() {
    if (!m_path.running())
        m_profile.step();
    else if (const auto velocity = m_path.next(controls(ScControl::kFastPath)))
        m_profile.stepPath(*velocity);
    else
        m_profile.endPath();
    const std::int64_t steps = std::exchange(m_pulses, 0);
    if (steps != 0 && controls(ScControl::kStepAndDirection))
        m_profile.shift(static_cast<std::int32_t>(steps * m_gains.sm));
}

void ServoLoop::setOutput(std::int64_t magnitude, bool reverse) {
    m_magnitude = static_cast<int>(magnitude);
    m_reverse = reverse;
    m_adjustment = std::min(m_adjustment, m_magnitude);
}

bool ServoLoop::currentIsOver() const {
    if (m_gains.cl == 0)
        return false;
    return m_gains.cl % 2 == 1 ? analog() > m_gains.cl : analog() < m_gains.cl;
}

/// The limit acts at the maximum rate, whatever the servo rate, and in PWM mode too (DS-V 4.3, 4.5).
void ServoLoop::limitCurrent() {
    m_limiting = currentIsOver();
    m_overcurrent = m_overcurrent || m_limiting;
    m_adjustment = std::clamp(m_adjustment + (m_limiting ? pwmSteps() : -pwmSteps()), 0, m_magnitude);
}

void ServoLoop::driveMotor() {
    int magnitude = m_magnitude - m_adjustment;
    // A raw PWM value reaches the amplifier unchanged (DS-V 4.5).
    if (magnitude > 0 && m_servoOn)
        magnitude = std::min(magnitude + m_gains.db * pwmSteps(), 255 * pwmSteps());
    m_pwm = m_reverse ? -magnitude : magnitude;
}

void ServoLoop::watchHome() {
    if (!m_homing.triggered(homeInputs(), m_tripped, m_limiting))
        return;
    saveAsHome();
    if (m_version < 3)
        return;  // Versions 1 and 2 leave the stop to the host.
    switch (m_homing.stop()) {
        case Homing::Stop::None:
            break;
        case Homing::Stop::Off:
            turnOff();
            break;
        case Homing::Stop::Abrupt:
            stopAbruptly();
            break;
        case Homing::Stop::Smooth:
            stopSmoothly();
            break;
    }
}

bool ServoLoop::limitPin(unsigned number) const {
    const unsigned control = m_pinControl;
    if ((control >> (2 + number) & 1U) == 0)
        return (control >> number & 1U) != 0;
    if (number == 0 && m_homeSwitchAt)
        return m_load >= *m_homeSwitchAt;
    if (!m_limitsAutomatic)
        return m_limitInput[number];
    const auto shaft = static_cast<double>(m_plant.shaft());
    // On an SC, LIMIT1 is the forward limit (docs/family.md).
    const bool atReverseEnd = (number == 0) != isSc();
    return atReverseEnd ? shaft <= motor().travelMinCounts : shaft >= motor().travelMaxCounts;
}

bool ServoLoop::indexPin() const {
    if (m_indexInput && m_plant.shaft() == m_indexInputAt)
        return *m_indexInput;
    return m_plant.index(m_encoderShaft);
}

std::uint8_t ServoLoop::analog() const {
    return m_analogInput ? *m_analogInput : m_plant.currentSense();
}

bool ServoLoop::inTrapezoid() const {
    return m_servoOn && m_profile.mode() == Profile::Mode::Trapezoidal && !m_profile.done();
}

std::uint8_t ServoLoop::statusByte() const {
    unsigned bits = 0;
    bits |= !m_servoOn || m_profile.done() ? 0x01U : 0U;
    bits |= m_overcurrent ? 0x04U : 0U;
    bits |= isPowered() ? 0x08U : 0U;
    bits |= m_positionError || !m_servoOn ? 0x10U : 0U;
    bits |= limitPin(0) ? 0x20U : 0U;
    bits |= limitPin(1) ? 0x40U : 0U;
    bits |= m_homing.inProgress() ? 0x80U : 0U;
    return static_cast<std::uint8_t>(bits);
}

std::uint8_t ServoLoop::auxiliaryByte() const {
    unsigned bits = 0;
    // Up to version 5: the complement of the index, and the phases that are over. On an SC: the index, and
    // the current phase.
    bits |= indexPin() == isSc() ? 0x01U : 0U;
    bits |= m_encoder.wrapped() ? 0x02U : 0U;
    bits |= m_servoOn ? 0x04U : 0U;
    bits |= (isSc() ? m_profile.accelerating() : m_profile.accelerationDone()) ? 0x08U : 0U;
    bits |= (isSc() ? m_profile.slewing() : m_profile.slewDone()) ? 0x10U : 0U;
    bits |= m_servoOverrun ? 0x20U : 0U;
    bits |= m_path.running() ? 0x40U : 0U;
    return static_cast<std::uint8_t>(bits);
}

ServoSnapshot ServoLoop::snapshot() const {
    ServoSnapshot s;
    s.position = m_encoder.position();
    s.shaftCounts = m_plant.shaftCounts();
    s.commandPosition = static_cast<double>(m_profile.finePosition()) / 65536.0;
    s.positionError = s.commandPosition - s.position;
    s.commandVelocity = static_cast<double>(m_profile.velocity()) / 65536.0;
    s.velocity = m_plant.speedCountsPerTick();
    s.amperes = m_plant.currentAmperes();
    s.pwm = m_pwm / pwmSteps();
    s.currentLimitAdjustment = m_adjustment / pwmSteps();
    s.analog = analog();
    s.analogInput = m_analogInput;
    s.servoOn = m_servoOn;
    // An SC lowers its enable outputs while its supply voltage is out of range.
    s.ampEnabled = m_ampEnabled && (!isSc() || isPowered());
    s.power = isPowered();
    if (m_servoOn && m_stoppedHere)
        s.mode = ServoMode::StopHere;
    else if (m_servoOn)
        s.mode =
            m_profile.mode() == Profile::Mode::Trapezoidal ? ServoMode::Trapezoidal : ServoMode::Velocity;
    s.home = m_home;
    s.limit1 = limitPin(0);
    s.limit2 = limitPin(1);
    s.index = indexPin();
    s.limitsAutomatic = m_limitsAutomatic;
    s.homeSwitchAt = m_homeSwitchAt;
    s.motor = motor();
    if (std::isfinite(s.motor.travelMinCounts))
        s.travelMin = s.motor.travelMinCounts;
    if (std::isfinite(s.motor.travelMaxCounts))
        s.travelMax = s.motor.travelMaxCounts;
    s.gains = m_gains;
    if (isLater())
        s.later = laterSnapshot();
    return s;
}

LaterServoSnapshot ServoLoop::laterSnapshot() const {
    LaterServoSnapshot s;
    s.pwm = static_cast<double>(m_pwm) / pwmSteps();
    s.pathPoints = static_cast<unsigned>(m_path.points());
    s.pathMode = m_path.running();
    s.fastPath = controls(ScControl::kFastPath);
    s.voltSense = m_volts;
    s.ioControl = m_control;
    s.limitStopsOff = protectsLimits() && controls(ScControl::kLimitOff);
    s.limitStopsAbruptly = protectsLimits() && !s.limitStopsOff;
    s.threePhase = controls(ScControl::kThreePhase);
    s.antiphase = controls(ScControl::kAntiphase);
    s.stepAndDirection = controls(ScControl::kStepAndDirection);
    return s;
}

}  // namespace nmc::sim
