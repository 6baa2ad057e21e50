// SPDX-License-Identifier: MIT
#include "sim/steppercontrol.h"

#include <algorithm>
#include <utility>

namespace nmc::sim {

void StepperControl::reset() {
    const StepperMachine machine = m_machine;
    *this = StepperControl{};
    m_machine = machine;
    m_pins = machine.pins();
    m_pinsChanged = true;
}

// ---- Time ----

void StepperControl::run(Duration time) {
    const bool shaftMovesPins = m_machine.shaftMovesPins();
    while (time > Duration::zero() && (m_pinsChanged || (shaftMovesPins && m_motion.isMoving()))) {
        const Duration tick = std::min(time, kServoTick);
        advance(tick);
        time -= tick;
        watchPins();
    }
    advance(time);
}

void StepperControl::advance(Duration time) {
    Duration rest = time;
    if (m_motion.isMoving()) {
        const std::int64_t before = m_motion.stepsMade();
        rest = m_motion.advance(time);
        // A disabled driver does not turn the motor, whatever the STEP output does.
        if (m_ampEnabled)
            m_machine.turn(m_motion.stepsMade() - before);
        m_pins = m_machine.pins();
        m_current.motionSeen();
    }
    if (!m_motion.isMoving())
        m_current.motorRests(rest);
}

// ---- Commands ----

void StepperControl::setParameters(const StepperParameters& parameters) {
    const StepperParameters before = std::exchange(m_parameters, parameters);
    m_hasParameters = true;
    m_current.setLimits(parameters.runningCurrent, parameters.holdingCurrent);
    m_pinsChanged = true;
    if (m_motion.isMoving()) {
        constexpr unsigned kSpeedMode = StepperParameters::kSpeedMode;
        m_parameters.mode =
            static_cast<std::uint8_t>((parameters.mode & ~kSpeedMode) | (before.mode & kSpeedMode));
        m_parameters.minimumSpeed = before.minimumSpeed;
    }
    m_motion.setSpeedMode(m_parameters.speedMode());
    m_motion.setMinimumSpeed(m_parameters.minimumSpeed);
}

void StepperControl::start(StepperMode goal) {
    const bool reverse = m_motion.wouldReverse(goal, m_loaded);
    if (driverFails() || estopActs() || limitActs(reverse)) {
        // The effect is the same as if it had started and been stopped by the pin at once.
        if (driverFails() || m_parameters.has(StepperParameters::kMotorOff))
            turnOff();
        return;
    }
    m_motion.start(goal, m_loaded);
    if (m_motion.isMoving())
        m_current.motionSeen();
}

void StepperControl::setAmplifier(bool enabled) {
    m_ampEnabled = enabled && !driverFails();
}

void StepperControl::stopAbruptly() {
    m_motion.stopAbruptly();
}

/// "Stop Motor command will have set the goal velocity to zero": this is said of the smooth stop only.
void StepperControl::stopSmoothly() {
    m_loaded.speed = 0;
    m_motion.stopSmoothly();
}

void StepperControl::turnOff() {
    m_ampEnabled = false;
    m_motion.stopAbruptly();
}

void StepperControl::setHoming(std::uint8_t control) {
    constexpr unsigned kUsed = 0x3F;
    m_homing.begin(static_cast<std::uint8_t>(control & kUsed), homePins());
}

// ---- Pins ----

void StepperControl::set(Input input, std::optional<double> value) {
    m_machine.set(input, value);
    m_pins = m_machine.pins();
    m_pinsChanged = true;
}

bool StepperControl::driverFails() const {
    return !m_pins.power || m_pins.analog < m_parameters.thermalLimit;
}

bool StepperControl::estopActs() const {
    return m_pins.estop && !m_parameters.has(StepperParameters::kIgnoreEstop);
}

bool StepperControl::limitActs(bool reverse) const {
    return (reverse ? m_pins.limit2 : m_pins.limit1) && !m_parameters.has(StepperParameters::kIgnoreLimits);
}

HomeInputs StepperControl::homePins() const {
    return {m_pins.limit1, m_pins.limit2, m_pins.homeSwitch};
}

void StepperControl::watchPins() {
    m_pinsChanged = false;
    watchHome();
    const bool motorOff = m_parameters.has(StepperParameters::kMotorOff);
    if (driverFails())
        turnOff();
    // The E-stop input also turns off a resting motor, but only once: the host may enable it again.
    if (estopActs()) {
        m_motion.stopAbruptly();
        if (motorOff && !m_estopSeen)
            turnOff();
    }
    m_estopSeen = estopActs();
    if (m_motion.isMoving() && limitActs(m_motion.isReverse())) {
        m_motion.stopAbruptly();
        if (motorOff)
            turnOff();
    }
}

void StepperControl::watchHome() {
    if (!m_homing.inProgress() || !m_homing.triggered(homePins(), false, false))
        return;
    saveAsHome();
    m_homing.stopMotor(*this);
}

// ---- Status ----

std::uint8_t StepperControl::statusByte() const {
    unsigned bits = m_motion.isMoving() ? 0x01U : 0U;
    bits |= m_ampEnabled ? 0x04U : 0U;
    bits |= m_pins.power ? 0x08U : 0U;
    bits |= m_motion.atCommandedSpeed() ? 0x10U : 0U;
    bits |= m_motion.mode() == StepperMode::Velocity ? 0x20U : 0U;
    bits |= m_motion.mode() == StepperMode::Trapezoidal ? 0x40U : 0U;
    bits |= m_homing.inProgress() ? 0x80U : 0U;
    return static_cast<std::uint8_t>(bits);
}

std::uint8_t StepperControl::inputsByte() const {
    unsigned bits = m_pins.estop ? 0x01U : 0U;
    bits |= m_pins.in1 ? 0x02U : 0U;
    bits |= m_pins.in2 ? 0x04U : 0U;
    bits |= m_pins.limit1 ? 0x08U : 0U;
    bits |= m_pins.limit2 ? 0x10U : 0U;
    bits |= m_pins.homeSwitch ? 0x20U : 0U;
    return static_cast<std::uint8_t>(bits);
}

StepperSnapshot StepperControl::snapshot() const {
    StepperSnapshot s;
    static_cast<StepperSurroundings&>(s) = m_machine.surroundings();
    s.position = m_motion.position();
    s.stepRate = m_motion.stepRate();
    s.speed = m_motion.speed();
    s.timerCount = m_motion.timerCount();
    s.mode = m_motion.mode();
    s.reverse = m_motion.isReverse();
    s.moving = m_motion.isMoving();
    s.ampEnabled = m_ampEnabled;
    s.home = m_home;
    if (m_hasParameters)
        s.parameters = m_parameters;
    s.inputs = m_pins;
    s.outputs = m_outputs;
    s.currentLimit = m_current.limit();
    return s;
}

}  // namespace nmc::sim
