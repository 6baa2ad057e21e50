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
    // On an SC, this ends PWM mode, too (docs/family.md, Choices).
    if (undervoltage() && (m_servoOn || (isSc() && m_magnitude != 0)))
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
    m_velocity = countsBetween(m_lastServoPosition, position);
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
    m_homing.stopMotor(*this);
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
    s.velocity = m_plant.speedCountsPerTick() * ticksPerServoTick();
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
    s.limitStopsOff = protectsLimits() && controls(ScControl::kLimitOff);
    s.limitStopsAbruptly = protectsLimits() && !s.limitStopsOff;
    s.threePhase = controls(ScControl::kThreePhase);
    s.antiphase = controls(ScControl::kAntiphase);
    s.stepAndDirection = controls(ScControl::kStepAndDirection);
    return s;
}

// ---- what changes it from outside: commands, and the world around the motor ----

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
    const auto back = [home = m_home](std::int32_t position) { return countsBetween(home, position); };
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
    m_profile.setAcceleration(t.acceleration);  // a smooth stop out of PWM mode decelerates, too
    m_loaded.pwm = t.pwm;
    // CMC and SC keep the present output when no value is loaded.
    if (isLater() && !t.has(Trajectory::kPwm))
        setOutput(present, reverse);
    else
        setOutput(t.pwm * pwmSteps(), t.has(Trajectory::kReverse));
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

/// "Current command velocity and goal velocity will be set to zero": the loaded parameter becomes 0, even one
/// that waits for Start Motion, so it must be loaded again before the next move. CMC and SC keep it.
void ServoLoop::forgetVelocity() {
    if (isLater())
        return;
    m_loaded.velocity = 0;
    m_loaded.velocityZeroed = true;
}

void ServoLoop::stopAbruptly() {
    turnServoOn();
    m_path.end();
    forgetVelocity();
    m_profile.stopAbruptly();
}

void ServoLoop::stopSmoothly() {
    turnServoOn();
    m_path.end();
    forgetVelocity();
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
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const bool level = value.value_or(0.0) != 0.0;
    MotorParameters p = m_plant.parameters();
    m_quiet = false;
    switch (input) {
        case Input::Limit1:
            m_limitInput[0] = level;
            return;
        case Input::Limit2:
            m_limitInput[1] = level;
            return;
        case Input::Limits:
            m_limitsAutomatic = level;
            return;
        case Input::Index:
            m_indexInput = level;
            m_indexInputAt = m_plant.shaft();
            return;
        case Input::Power:
            m_volts = level ? kGoodVolts : 0.0;
            return;
        case Input::VoltSense:
            m_volts = value.value_or(kGoodVolts);
            return;
        case Input::Analog:
            m_analogInput.reset();
            if (value)
                m_analogInput = static_cast<std::uint8_t>(*value);
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
        case Input::Load:
            p.loadNm = value.value_or(0.0);
            break;
        case Input::Inertia:
            p.inertiaKgM2 = value.value_or(p.inertiaKgM2);
            break;
        case Input::Friction:
            p.coulombNm = value.value_or(p.coulombNm);
            break;
        case Input::Play:
            p.playCounts = static_cast<std::int64_t>(value.value_or(0.0));
            break;
        case Input::LoadPlay:
            p.loadPlayCounts = static_cast<std::int64_t>(value.value_or(0.0));
            break;
        case Input::CountsPerTurn:
            p.countsPerTurn = value.value_or(p.countsPerTurn);
            break;
        case Input::Deadband:
            p.amplifierDeadbandPwm = static_cast<int>(value.value_or(0.0));
            break;
        case Input::Gain:
            p.setGain(value.value_or(p.gain()));
            break;
        case Input::EncoderNoise:
            p.encoderNoiseCounts = value.value_or(0.0);
            break;
        case Input::ElasticInertia:
            p.elasticInertiaKgM2 = value.value_or(0.0);
            break;
        case Input::Resonance:
            p.resonanceHz = value.value_or(p.resonanceHz);
            break;
        case Input::TravelMin:
            p.travelMinCounts = value.value_or(-kInfinity);
            break;
        case Input::TravelMax:
            p.travelMaxCounts = value.value_or(kInfinity);
            break;
        case Input::Pin:  // PIC-I/O only
        case Input::Estop:
        case Input::In1:
        case Input::In2:
        case Input::HomeSwitch:
            return;  // PIC-STEP only
    }
    m_plant.setParameters(p);
}

void ServoLoop::holdShaft(bool held) {
    m_plant.hold(held);
    m_quiet = false;
}

void ServoLoop::reverseEncoder(bool reversed) {
    m_encoder.setReversed(reversed);
    m_quiet = false;
}

}  // namespace nmc::sim
