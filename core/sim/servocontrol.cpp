// SPDX-License-Identifier: MIT
// What changes a servo loop from outside: the host's commands, and the world around the motor.
#include "sim/servoloop.h"

#include "base/strong.h"

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
    fresh.m_noise = m_noise;
    fresh.m_encoderShaft = m_encoderShaft;
    fresh.m_load = m_load;
    fresh.m_homeSwitchAt = m_homeSwitchAt;
    // The counter restarts from 0 wherever the shaft is.
    fresh.m_encoder = m_encoder;
    fresh.m_encoder.reset();
    fresh.m_encoder.clearWrapped();
    fresh.m_volts = m_volts;
    fresh.m_limitsAutomatic = m_limitsAutomatic;
    fresh.m_limitInput[0] = m_limitInput[0];
    fresh.m_limitInput[1] = m_limitInput[1];
    fresh.m_analogInput = m_analogInput;
    fresh.m_indexInput = m_indexInput;
    fresh.m_indexInputAt = m_indexInputAt;
    *this = fresh;
}

void ServoLoop::setPosition(std::int32_t position) {
    m_encoder.setPosition(position);
    m_profile.rename(position);
    m_lastServoPosition = position;
    m_quiet = false;
}

/// The command position keeps its distance from the position, so nothing moves.
void ServoLoop::resetRelativeToHome() {
    const auto back = [home = m_home](std::int32_t position) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(position) -
                                         static_cast<std::uint32_t>(home));
    };
    const std::int32_t command = m_profile.position();
    m_encoder.setPosition(back(m_encoder.position()));
    m_profile.shift(countsBetween(command, back(command)));
    m_lastServoPosition = back(m_lastServoPosition);
    m_quiet = false;
}

void ServoLoop::setGains(const Gains& gains) {
    m_gains = gains;
    m_ticksToServoTick = 1;
    m_quiet = false;
}

void ServoLoop::turnServoOn() {
    if (!m_servoOn) {
        // At a low servo rate the command position may lag some ticks behind the motor.
        m_profile.follow(m_encoder.position(), m_velocity);
        m_filter.reset();
        m_servoOn = true;
    }
    m_stoppedHere = false;
    m_fault = false;
    m_quiet = false;
}

/// Whatever ends servoing also sets the PWM value to 0 (DS-V 4.5), including the one that waits for Start
/// Motion.
void ServoLoop::disableServo() {
    m_servoOn = false;
    m_path.end();
    m_positionError = true;
    m_loaded.pwm = 0;
    setOutput(0, false);
    m_filter.reset();
    m_profile.follow(m_encoder.position(), m_velocity);
    m_quiet = false;
}

/// Disables the servo like disableServo(), but without a command from the host.
void ServoLoop::fault() {
    disableServo();
    m_fault = true;
}

void ServoLoop::start() {
    const Trajectory& t = m_loaded;
    if (protectsLimits() && isBlocked(loadedDirection()))
        return;
    if (!t.has(Trajectory::kServo))
        return startPwm();
    m_path.end();
    turnServoOn();
    if (t.isTrapezoidal()) {
        // CMC and SC allow a move to be changed while it runs.
        m_profile.startTrapezoid(loadedGoal(), t.velocity, t.acceleration,
                                 isLater() ? Profile::Start::AtPresentVelocity : Profile::Start::AtZero);
        return;
    }
    const std::int64_t velocity = t.velocity;
    m_profile.startVelocity(t.has(Trajectory::kReverse) ? -velocity : velocity, t.acceleration);
}

void ServoLoop::startPwm() {
    const Trajectory t = m_loaded;
    const int present = m_magnitude;
    const bool reverse = m_reverse;
    disableServo();
    m_loaded.pwm = t.pwm;
    // CMC and SC keep the present output when no value is loaded.
    if (isLater() && !t.has(Trajectory::kPwm))
        setOutput(undervoltage() ? 0 : present, reverse);
    else
        setOutput(undervoltage() ? 0 : t.pwm * pwmSteps(), t.has(Trajectory::kReverse));
    driveMotor();
}

std::int32_t ServoLoop::loadedGoal() const {
    if (!isLater() || !m_loaded.has(Trajectory::kRelative))
        return m_loaded.position;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(m_profile.position()) +
                                     static_cast<std::uint32_t>(m_loaded.position));
}

int ServoLoop::loadedDirection() const {
    const Trajectory& t = m_loaded;
    if (t.isTrapezoidal()) {
        const std::int32_t way = countsBetween(m_profile.position(), loadedGoal());
        return way > 0 ? 1 : way < 0 ? -1 : 0;
    }
    if (t.has(Trajectory::kServo) ? t.velocity == 0 : t.pwm == 0)
        return 0;
    return t.has(Trajectory::kReverse) ? -1 : 1;
}

void ServoLoop::startPath() {
    turnServoOn();
    m_path.start();
}

void ServoLoop::endPath() {
    if (!m_path.running())
        return;
    m_path.end();
    m_profile.endPath();
}

void ServoLoop::holdPosition() {
    turnServoOn();
    m_profile.hold(m_encoder.position());
}

// ---- Limit protection of an SC ----

bool ServoLoop::protectsLimits() const {
    return isSc() && !controls(ScControl::kStepAndDirection) &&
           (controls(ScControl::kLimitOff) || controls(ScControl::kLimitAbrupt));
}

bool ServoLoop::isBlocked(int direction) const {
    return direction != 0 && limitPin(direction > 0 ? 0 : 1);
}

void ServoLoop::protectLimits() {
    const int driven = m_magnitude == 0 ? 0 : m_reverse ? -1 : 1;
    if (!isBlocked(m_servoOn ? m_profile.direction() : driven))
        return;
    if (m_servoOn && !controls(ScControl::kLimitOff))
        stopAbruptly();
    else
        disableServo();
}

void ServoLoop::setAmplifier(bool enabled) {
    m_ampEnabled = enabled;
    m_quiet = false;
}

void ServoLoop::turnOff() {
    disableServo();
    driveMotor();
}

// "Current command velocity and goal velocity will be set to zero": the loaded parameter becomes 0, so it
// must be loaded again before the next move. CMC and SC keep it.
void ServoLoop::stopAbruptly() {
    turnServoOn();
    m_path.end();
    if (!isLater())
        m_loaded.velocity = 0;
    m_profile.stopAbruptly();
}

void ServoLoop::stopSmoothly() {
    turnServoOn();
    const bool onPath = m_path.running();
    m_path.end();
    // A path has no acceleration of its own, so the loaded one is used.
    if (onPath)
        return m_profile.startVelocity(0, m_loaded.acceleration);
    if (!isLater())
        m_loaded.velocity = 0;
    m_profile.stopSmoothly();
}

void ServoLoop::stopHere(std::int32_t position) {
    turnServoOn();
    m_path.end();
    m_stoppedHere = true;
    m_profile.hold(position);
}

void ServoLoop::controlPins(std::uint8_t control) {
    if (!isSc())
        m_pinControl = static_cast<std::uint8_t>(control & 0x0FU);
    if (isLater())
        m_control = static_cast<std::uint8_t>(control & (isSc() ? 0xFFU : ScControl::kFastPath));
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
        case Input::Play:
        case Input::LoadPlay:
        case Input::CountsPerTurn:
        case Input::Deadband:
        case Input::Gain:
        case Input::EncoderNoise:
        case Input::ElasticInertia:
        case Input::Resonance:
        case Input::TravelMin:
        case Input::TravelMax:
            setLoad(input, value);
            return;
        case Input::HomeSwitchAt:
            m_homeSwitchAt.reset();
            if (value)
                m_homeSwitchAt = static_cast<std::int64_t>(*value);
            return;
        case Input::ServoOverrun:
            m_servoOverrun = true;
            return;
        case Input::Pulses:
            m_pulses += static_cast<std::int64_t>(value.value_or(0.0));
            return;
        case Input::VoltSense:
            m_volts = value.value_or(kGoodVolts);
            return;
        case Input::Pin:  // PIC-I/O only
        case Input::Estop:
        case Input::In1:
        case Input::In2:
        case Input::HomeSwitch:
            return;  // PIC-STEP only
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
        m_volts = level ? kGoodVolts : 0.0;
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
    if (input == Input::Play)
        p.playCounts = static_cast<std::int64_t>(value.value_or(0.0));
    if (input == Input::LoadPlay)
        p.loadPlayCounts = static_cast<std::int64_t>(value.value_or(0.0));
    if (input == Input::CountsPerTurn)
        p.countsPerTurn = value.value_or(p.countsPerTurn);
    if (input == Input::Deadband)
        p.amplifierDeadbandPwm = static_cast<int>(value.value_or(0.0));
    if (input == Input::Gain)
        p.setGain(value.value_or(p.gain()));
    if (input == Input::EncoderNoise)
        p.encoderNoiseCounts = value.value_or(0.0);
    if (input == Input::ElasticInertia)
        p.elasticInertiaKgM2 = value.value_or(0.0);
    if (input == Input::Resonance)
        p.resonanceHz = value.value_or(p.resonanceHz);
    if (input == Input::TravelMin)
        p.travelMinCounts = value.value_or(-kInfinity);
    if (input == Input::TravelMax)
        p.travelMaxCounts = value.value_or(kInfinity);
    m_plant.setParameters(p);
}

}  // namespace nmc::sim
