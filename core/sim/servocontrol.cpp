// SPDX-License-Identifier: MIT
// What changes a servo loop from outside: the host's commands and the world around the motor.
#include "sim/servoloop.h"

namespace nmc::sim {

std::string_view toText(ServoMode mode) {
    switch (mode) {
        case ServoMode::Pwm:
            return "pwm";
        case ServoMode::Velocity:
            return "velocity";
        case ServoMode::Trapezoidal:
            return "trapezoidal";
        case ServoMode::StopHere:
            return "stop-here";
    }
    return "";
}

void ServoLoop::reset() {
    ServoLoop fresh(m_version);
    fresh.m_plant = m_plant;
    // The counter starts from 0 wherever the shaft stands.
    fresh.m_encoder = m_encoder;
    fresh.m_encoder.reset();
    fresh.m_encoder.clearWrapped();
    fresh.m_power = m_power;
    fresh.m_limitsAutomatic = m_limitsAutomatic;
    fresh.m_limitInput[0] = m_limitInput[0];
    fresh.m_limitInput[1] = m_limitInput[1];
    fresh.m_analogInput = m_analogInput;
    fresh.m_indexInput = m_indexInput;
    fresh.m_indexInputAt = m_indexInputAt;
    *this = fresh;
}

void ServoLoop::resetPosition() {
    m_encoder.reset();
    m_profile.rename(0);
    m_lastServoPosition = 0;
    m_quiet = false;
}

void ServoLoop::setGains(const Gains& gains) {
    m_gains = gains;
    m_ticksToServoTick = 1;
    m_quiet = false;
}

void ServoLoop::turnServoOn() {
    if (!m_servoOn) {
        // At a low servo rate the command may be some ticks behind the motor.
        m_profile.follow(m_encoder.position(), m_velocity);
        m_filter.reset();
        m_servoOn = true;
    }
    m_stoppedHere = false;
    m_quiet = false;
}

/// Whatever ends servoing also makes the PWM value 0 (DS-V 4.5), the one waiting for Start Motion too.
void ServoLoop::disableServo() {
    m_servoOn = false;
    m_positionError = true;
    m_loaded.pwm = 0;
    setOutput(0, false);
    m_filter.reset();
    m_profile.follow(m_encoder.position(), m_velocity);
    m_quiet = false;
}

void ServoLoop::start() {
    const Trajectory& t = m_loaded;
    if (!t.has(Trajectory::kServo)) {
        const std::uint8_t pwm = t.pwm;
        const bool reverse = t.has(Trajectory::kReverse);
        disableServo();
        m_loaded.pwm = pwm;
        setOutput(m_power ? pwm : 0, reverse);
        driveMotor();
        return;
    }
    turnServoOn();
    if (t.isTrapezoidal()) {
        m_profile.startTrapezoid(t.position, t.velocity, t.acceleration);
        return;
    }
    const std::int64_t velocity = t.velocity;
    m_profile.startVelocity(t.has(Trajectory::kReverse) ? -velocity : velocity, t.acceleration);
}

void ServoLoop::setAmplifier(bool enabled) {
    m_ampEnabled = enabled;
    m_quiet = false;
}

void ServoLoop::turnOff() {
    disableServo();
    driveMotor();
}

// "Current command velocity and goal velocity will be set to zero": it is the loaded parameter that becomes
// 0, so that it has to be loaded again before the next move.
void ServoLoop::stopAbruptly() {
    turnServoOn();
    m_loaded.velocity = 0;
    m_profile.stopAbruptly();
}

void ServoLoop::stopSmoothly() {
    turnServoOn();
    m_loaded.velocity = 0;
    m_profile.stopSmoothly();
}

void ServoLoop::stopHere(std::int32_t position) {
    turnServoOn();
    m_stoppedHere = true;
    m_profile.hold(position);
}

void ServoLoop::controlPins(std::uint8_t control) {
    m_pinControl = control;
    m_quiet = false;
}

void ServoLoop::setHoming(std::uint8_t control) {
    m_homing.begin(control, homeInputs());
    m_quiet = false;
}

void ServoLoop::clearStickyBits() {
    m_overcurrent = false;
    m_positionError = !m_servoOn;
    m_servoOverrun = false;
    m_encoder.clearWrapped();
}

void ServoLoop::set(Input input, std::optional<double> value) {
    m_quiet = false;
    switch (input) {
        case Input::Limit1:
        case Input::Limit2:
        case Input::Index:
        case Input::Power:
        case Input::Limits:
            setSwitch(input, value.value_or(0.0) != 0.0);
            return;
        case Input::Analog:
            m_analogInput.reset();
            if (value)
                m_analogInput = static_cast<std::uint8_t>(*value);
            return;
        case Input::Load:
        case Input::Inertia:
        case Input::Friction:
        case Input::TravelMin:
        case Input::TravelMax:
            setLoad(input, value);
            return;
        case Input::ServoOverrun:
            m_servoOverrun = true;
            return;
        case Input::Estop:
        case Input::In1:
        case Input::In2:
        case Input::HomeSwitch:
        case Input::HomeSwitchAt:
            return;  // A stepper's.
    }
}

void ServoLoop::holdShaft(bool held) {
    m_plant.hold(held);
    m_quiet = false;
}

void ServoLoop::reverseEncoder(bool reversed) {
    m_encoder.setReversed(reversed);
    m_quiet = false;
}

void ServoLoop::setSwitch(Input input, bool level) {
    if (input == Input::Limit1)
        m_limitInput[0] = level;
    if (input == Input::Limit2)
        m_limitInput[1] = level;
    if (input == Input::Power)
        m_power = level;
    if (input == Input::Limits)
        m_limitsAutomatic = level;
    if (input == Input::Index) {
        m_indexInput = level;
        m_indexInputAt = m_plant.shaft();
    }
}

void ServoLoop::setLoad(Input input, std::optional<double> value) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    MotorParameters p = m_plant.parameters();
    if (input == Input::Load)
        p.loadNm = value.value_or(0.0);
    if (input == Input::Inertia)
        p.inertiaKgM2 = value.value_or(p.inertiaKgM2);
    if (input == Input::Friction)
        p.coulombNm = value.value_or(p.coulombNm);
    if (input == Input::TravelMin)
        p.travelMinCounts = value.value_or(-kInfinity);
    if (input == Input::TravelMax)
        p.travelMaxCounts = value.value_or(kInfinity);
    m_plant.setParameters(p);
}

}  // namespace nmc::sim
