// SPDX-License-Identifier: MIT
#include "bus/belief.h"

#include <algorithm>
#include <cstdlib>

#include "base/overloaded.h"
#include "bus/standstill.h"
#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

// A load without a value uses the one loaded before, which is unknown here.
[[nodiscard]] bool drivesPwm(const servo::LoadTrajectory& load) {
    return !load.servo && load.pwm.value_or(1) != 0;
}
[[nodiscard]] bool runs(const servo::LoadTrajectory& load) {
    return load.isVelocityMode() && load.velocity.value_or(CountsPerTick(1)).value() != 0;
}
[[nodiscard]] bool stopsAtHome(const servo::SetHoming& homing) {
    return homing.watches() && (homing.motorOff || homing.stopAbruptly || homing.stopSmoothly);
}
/// PIC-STEP: the longer of two acceleration times, with the longer way of a stop; empty if one is unknown.
[[nodiscard]] std::optional<std::uint8_t> longer(std::optional<std::uint8_t> one,
                                                 std::optional<std::uint8_t> other) {
    return one && other ? std::optional(std::max(*one, *other)) : std::nullopt;
}

}  // namespace

struct Belief::Sent {
    Belief& b;
    TimePoint latched;

    void operator()(const servo::LoadTrajectory& load) const {
        b.m_servo.loadWaiting = false;
        if (!load.startNow)
            return;
        b.m_lastMotion = latched;
        b.m_may.starting = load;
        b.mayStart(load);
    }
    void operator()(const stepper::LoadTrajectory& load) const {
        b.m_stepper.waiting.reset();
        if (load.accelerationTime)
            b.m_stepper.loadedTime = longer(b.m_stepper.loadedTime, load.accelerationTime);
        if (!load.startNow)
            return;
        b.m_lastMotion = latched;
        b.mayStart(load);
    }
    void operator()(const StartMotion&) const {
        b.m_lastMotion = latched;
        b.m_may.starting = b.servoLoad();
        if (b.m_may.starting)
            b.mayStart(*b.m_may.starting);
        if (b.m_stepper.waiting)
            b.mayStart(*b.m_stepper.waiting);
        b.forgetLoad();
    }
    void operator()(const servo::StopMotor& stop) const {
        b.m_amplifierOff = b.m_amplifierOff && !stop.amplifierEnable;
        if (stop.manner == servo::StopManner::AmplifierOnly)
            return;
        b.m_lastMotion = latched;
        b.m_servo.loadWaiting = false;  // DS-V 5.2: the velocity parameter becomes 0
        // Velocity mode is entered by a smooth stop, too, and only a servo that is on has it (DS-V 4.5, 5.2).
        if (stop.manner != servo::StopManner::MotorOff)
            b.m_may.enable = true;
    }
    void operator()(const stepper::StopMotor& stop) const {
        b.m_lastMotion = latched;
        b.m_may.enable = b.m_may.enable || stop.amplifierEnable;
        if (stop.manner != stepper::StopManner::AmplifierOnly)
            b.m_stepper.waiting.reset();
    }
    void operator()(const servo::SetHoming& homing) const {
        b.m_homingStops = b.m_homingStops && stopsAtHome(homing);
    }
    void operator()(const servo::SetGain& gain) const {
        if (b.m_servo.servoRate != int{gain.sr})
            b.m_servo.servoRate.reset();
    }
    void operator()(const DefineStatus&) const { b.forgetItems(); }
    void operator()(const SetAddress&) const { b.m_info.group.reset(); }
    void operator()(const AnyOf<servo::IoControl, servo::ScIoControl> auto&) const {
        b.m_servo.pathControl.reset();
    }
    void operator()(const servo::AddPathPoints& add) const {
        if (!add.startsPath())
            return;
        b.m_lastMotion = latched;
        b.m_may.followPath = b.m_may.enable = true;
    }
    void operator()(const io::OwnCommand auto& command) const { b.m_outputs.onSent(command); }
    void operator()(const auto& /*other*/) const {}
};

struct Belief::Executed {
    Belief& b;

    void operator()(const servo::LoadTrajectory& load) const {
        if (load.startNow)
            b.started(load);
    }
    void operator()(const stepper::SetParameters&) const { b.m_parametersSet = true; }
    void operator()(const StartMotion&) const {
        if (b.m_may.starting)
            b.started(*b.m_may.starting);
    }
    void operator()(const servo::StopMotor& stop) const {
        b.m_amplifierOff = !stop.amplifierEnable;
        if (stop.manner == servo::StopManner::AmplifierOnly)
            return;
        b.m_may.run = b.m_may.followPath = b.m_may.drivePwm = b.m_may.pwmUnknown = false;
        if (stop.manner == servo::StopManner::MotorOff)
            b.m_on = b.m_may.enable = false;
    }
    void operator()(const servo::SetHoming& homing) const { b.m_homingStops = stopsAtHome(homing); }
    void operator()(const DefineStatus& define) const { b.m_items = define.items; }
    void operator()(const SetAddress& set) const {
        b.m_info.group = GroupPlace{set.group.value(), set.leader};
    }
    void operator()(const auto& /*other*/) const {}
};

void Belief::onSent(const ModuleCommand& command, TimePoint latched) {
    if (setsCounter(command)) {
        rename();
        forgetLoad();  // its goal counts from the zero of before
    }
    visitCommand(Sent{*this, latched}, command);
}

void Belief::onExecuted(const ModuleCommand& command, const StatusReport* answer) {
    if (setsCounter(command))
        rename();
    // Home was found before this motion began, so that does not stop it.
    if (answer != nullptr && mayStartMotion(command) && !answer->servoStatus().homeInProgress())
        m_homingStops = false;
    visitCommand(Executed{*this}, command);
    std::visit(Overloaded{[this](const ServoCommand& own) { m_servo.apply(own, m_info.identity); },
                          [this](const StepperCommand& own) { m_stepper.apply(own); },
                          [this](const IoCommand& own) { m_outputs.onExecuted(own); }},
               command);
}

void Belief::onNotExecuted(const Belief& before) {
    m_may = before.m_may;
    m_stepper.waiting = before.m_stepper.waiting;
    m_stepper.accelerationTime = before.m_stepper.accelerationTime;
    m_servo.loadWaiting = before.m_servo.loadWaiting;
    m_servo.runningVelocity = before.m_servo.runningVelocity;
    m_servo.runningAcceleration = before.m_servo.runningAcceleration;
    m_outputs.onNotExecuted(before.m_outputs);
}

void Belief::onStatus(const StatusReport& report, TimePoint latched) {
    if (m_statusTime && latched < *m_statusTime)
        return;
    m_before = m_statusTime;
    m_statusTime = latched;
    m_last = report;
    if (report.position)
        onPosition(*report.position, latched);
    if (report.home)
        m_home = report.home;
    if (const auto commanded = report.commandPosition())
        m_commandPosition = commanded;
    if (report.aux)
        m_aux = *report.aux;
    if (report.pins)
        m_outputs.onPins(*report.pins);
    if (m_info.identity.type == ModuleType::Stepper) {
        m_on = report.stepperStatus().amplifierEnabled();
        m_may.enable = m_may.enable && !fresh();
        return;
    }
    // The reply to a command may have been composed before the command took effect.
    if (!fresh())
        return;
    if (report.aux) {
        m_on = servo::AuxByte{*report.aux}.servoOn();
        m_may.enable = false;
        m_may.run = m_may.run && m_on;
        m_may.followPath =
            m_may.followPath && (servo::AuxByte{m_aux}.pathMode() || !report.servoStatus().moveDone());
    }
    const servo::StatusByte status = report.servoStatus();
    if (m_homingStops && !status.homeInProgress())
        m_may.run = m_homingStops = false;
    if (status.moveDone() && m_servo.limitEnds(status, m_may.runReverse))
        m_may.run = false;
}

void Belief::onPosition(std::int32_t position, TimePoint latched) {
    m_position = position;
    // An encoder at rest on an edge alternates by one count.
    const bool moved = m_place && std::abs(std::int64_t{countsBetween(m_place->position, position)}) > 1;
    if (m_place && !moved && latched - m_place->since < kRollTime)
        return;
    m_rolls = moved;
    m_place = {position, latched};
}

/// The reply to a command that sets the counter may contain the old or the new position.
void Belief::rename() {
    m_place.reset();
    m_rolls = false;
}

void Belief::setRestarted() {
    m_restarted = true;
    m_info.group = GroupPlace{};
    m_on = m_homingStops = m_parametersSet = false;
    m_may = {};
    m_servo = {};
    m_stepper = {};
    m_outputs.onReset();
}

unsigned Belief::looksSince(TimePoint time) const {
    const auto since = [&](const std::optional<TimePoint>& at) { return at && *at >= time ? 1U : 0U; };
    return since(m_statusTime) + since(m_before);
}

bool anySticky(servo::StatusByte status, servo::AuxByte aux) {
    return status.overcurrent() || (status.positionError() && aux.servoOn()) || aux.positionWrap() ||
           aux.servoOverrun();
}

StatusItems Belief::otherItems() const {
    const ModuleIdentity& identity = m_info.identity;
    return m_last.items == fullItems(identity) ? standingItems(identity) : fullItems(identity);
}

bool Belief::fresh() const {
    return m_statusTime && (!m_lastMotion || *m_statusTime > *m_lastMotion);
}

bool Belief::moves(bool servo) const {
    if (!m_statusTime)
        return true;
    if (m_info.identity.type == ModuleType::Io)
        return false;
    if (m_info.identity.type == ModuleType::Stepper)
        return m_last.stepperStatus().moving();
    return servo || !m_last.servoStatus().moveDone();
}

bool Belief::showsMotion() const {
    return nmc::showsMotion(m_info.identity.type, m_last);
}

StepperMode Belief::stepperMode() const {
    return mayMove() ? m_may.stepperRun.modeNow(m_last.stepperStatus()) : StepperMode::Stopped;
}

void Belief::mayStart(const servo::LoadTrajectory& load) {
    m_may.drivePwm = m_may.drivePwm || drivesPwm(load);
    m_may.run = m_may.run || runs(load);
    // Until the answer, the old motion may go on or the new one: at worst the faster, with the longer stop.
    m_servo.runningVelocity =
        std::max(m_servo.runningVelocity, load.velocity ? load.velocity : m_servo.velocity);
    m_servo.runningAcceleration =
        std::min(m_servo.runningAcceleration, load.acceleration ? load.acceleration : m_servo.acceleration);
    if (!load.servo)
        return;
    m_may.enable = true;
    m_may.runReverse = load.reverse;
}

/// Until the answer, the old motion may go on or the new one, as with a PIC-SERVO.
void Belief::mayStart(const stepper::LoadTrajectory& load) {
    m_may.stepperRun.start(load, stepperMode(), m_position);
    m_stepper.accelerationTime = longer(m_stepper.accelerationTime, m_stepper.loadedTime);
}

void Belief::started(const servo::LoadTrajectory& load) {
    m_may.pwmUnknown = false;
    m_may.drivePwm = drivesPwm(load);
    m_may.run = runs(load);
    m_may.starting.reset();
}

}  // namespace nmc::bus
