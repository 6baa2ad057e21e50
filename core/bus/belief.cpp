// SPDX-License-Identifier: MIT
#include "bus/belief.h"

#include <cstdlib>

#include "base/overloaded.h"
#include "module/commandfacts.h"

namespace nmc::bus {

struct Belief::Sent {
    Belief& b;
    TimePoint latched;

    void operator()(const servo::LoadTrajectory& load) const {
        b.m_servo.loadWaiting = false;
        if (!load.startNow)
            return;
        b.m_lastMotion = latched;
        b.m_starting = load;
        b.mayStart(load);
    }
    void operator()(const stepper::LoadTrajectory& load) const {
        b.m_stepper.waiting.reset();
        if (!load.startNow)
            return;
        b.m_lastMotion = latched;
        b.m_stepperRun.start(load, b.stepperMode(), b.m_position);
    }
    void operator()(const StartMotion&) const {
        b.m_lastMotion = latched;
        b.m_starting = b.servoLoad();
        if (b.m_starting)
            b.mayStart(*b.m_starting);
        if (const auto& waiting = b.m_stepper.waiting) {
            b.m_stepperRun.start(*waiting, b.stepperMode(), b.m_position);
            if (waiting->accelerationTime)
                b.m_stepper.accelerationTime = waiting->accelerationTime;
        }
        b.forgetLoad();
    }
    void operator()(const servo::StopMotor& stop) const {
        b.m_amplifierOff = b.m_amplifierOff && !stop.amplifierEnable;
        if (stop.manner == servo::StopManner::AmplifierOnly)
            return;
        b.m_lastMotion = latched;
        b.m_servo.loadWaiting = false;  // DS-V 5.2: the velocity parameter becomes 0
        if (stop.manner == servo::StopManner::Abruptly || stop.manner == servo::StopManner::Here)
            b.m_mayEnable = true;
    }
    void operator()(const stepper::StopMotor& stop) const {
        b.m_lastMotion = latched;
        b.m_mayEnable = b.m_mayEnable || stop.amplifierEnable;
        if (stop.manner != stepper::StopManner::AmplifierOnly)
            b.m_stepper.waiting.reset();
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
        b.m_onPath = b.m_mayEnable = true;
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
        if (b.m_starting)
            b.started(*b.m_starting);
    }
    void operator()(const servo::StopMotor& stop) const {
        b.m_amplifierOff = !stop.amplifierEnable;
        if (stop.manner == servo::StopManner::AmplifierOnly)
            return;
        b.m_velocityGoal = b.m_onPath = false;
        b.m_pwmMayRun = b.m_pwmUnknown = false;
        if (stop.manner == servo::StopManner::MotorOff)
            b.m_on = b.m_mayEnable = false;
    }
    void operator()(const servo::SetHoming& homing) const {
        b.m_homingStops = homing.motorOff || homing.stopAbruptly || homing.stopSmoothly;
    }
    void operator()(const DefineStatus& define) const { b.m_items = define.items; }
    void operator()(const SetAddress& set) const {
        b.m_info.group = GroupPlace{set.group.value(), set.leader};
    }
    void operator()(const servo::ScIoControl& control) const {
        b.m_limitStops = control.limitStop != servo::LimitStop::None;
    }
    void operator()(const auto& /*other*/) const {}
};

void Belief::onSent(const ModuleCommand& command, TimePoint latched) {
    if (setsCounter(command))
        rename();
    visitCommand(Sent{*this, latched}, command);
}

void Belief::onExecuted(const ModuleCommand& command) {
    if (setsCounter(command))
        rename();
    visitCommand(Executed{*this}, command);
    std::visit(Overloaded{[this](const ServoCommand& own) { m_servo.apply(own); },
                          [this](const StepperCommand& own) { m_stepper.apply(own); },
                          [this](const IoCommand& own) { m_outputs.onExecuted(own); }},
               command);
}

void Belief::onNotExecuted(const Belief& before) {
    m_mayEnable = before.m_mayEnable;
    m_pwmMayRun = before.m_pwmMayRun;
    m_velocityGoal = before.m_velocityGoal;
    m_stepperRun = before.m_stepperRun;
    m_stepper.waiting = before.m_stepper.waiting;
    m_servo.loadWaiting = before.m_servo.loadWaiting;
    m_starting = before.m_starting;
    m_onPath = before.m_onPath;
}

void Belief::onStatus(const StatusReport& report, TimePoint latched) {
    if (m_statusTime && latched < *m_statusTime)
        return;
    m_before = m_statusTime;
    m_statusTime = latched;
    m_lastItems = report.items;
    if (report.position) {
        // An encoder at rest on an edge alternates by one count.
        m_rolls = m_place && std::abs(countsBetween(*m_place, *report.position)) > 1;
        m_place = m_position = report.position;
    }
    if (report.home)
        m_home = report.home;
    if (const auto commanded = report.commandPosition())
        m_commandPosition = commanded;
    if (report.aux)
        m_aux = *report.aux;
    m_status = report.status;
    m_velocity = report.velocity;
    if (report.pins)
        m_outputs.onPins(*report.pins);
    if (m_info.identity.type == ModuleType::Stepper) {
        m_on = report.stepperStatus().amplifierEnabled();
        m_mayEnable = m_mayEnable && !fresh();
        return;
    }
    // The reply to a command may have been composed before the command took effect.
    if (!fresh())
        return;
    if (report.aux) {
        m_on = servo::AuxByte{*report.aux}.servoOn();
        m_mayEnable = false;
        if (!m_on)
            m_velocityGoal = false;
        m_onPath = m_onPath && (servo::AuxByte{m_aux}.pathMode() || !report.servoStatus().moveDone());
    }
    const servo::StatusByte status = report.servoStatus();
    if (m_homingStops && !status.homeInProgress())
        m_velocityGoal = m_homingStops = false;
    if (m_limitStops && status.moveDone() && (m_velocityReverse ? status.limit2() : status.limit1()))
        m_velocityGoal = false;
}

/// The reply to a command that sets the counter may contain the old or the new position.
void Belief::rename() {
    m_place.reset();
    m_rolls = false;
}

void Belief::setRestarted() {
    m_restarted = true;
    m_info.group = GroupPlace{};
    m_on = m_mayEnable = m_pwmMayRun = m_pwmUnknown = m_velocityGoal = m_homingStops = m_limitStops =
        m_parametersSet = m_onPath = false;
    m_servo = {};
    m_stepper = {};
    m_starting.reset();
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
    return m_lastItems == fullItems(identity) ? standingItems(identity) : fullItems(identity);
}

bool Belief::fresh() const {
    return m_statusTime && (!m_lastMotion || *m_statusTime > *m_lastMotion);
}

bool Belief::mayMove() const {
    if (m_restarted)
        return false;
    if (!m_statusTime)
        return true;
    if (m_info.identity.type == ModuleType::Io)
        return false;
    if (m_info.identity.type == ModuleType::Stepper)
        return stepper::StatusByte{m_status}.moving();
    return m_velocityGoal || m_pwmMayRun || m_onPath || !servo::StatusByte{m_status}.moveDone();
}

bool Belief::seenMoving() const {
    if (!m_statusTime)
        return true;
    if (m_info.identity.type == ModuleType::Io)
        return false;
    if (m_info.identity.type == ModuleType::Stepper)
        return stepper::StatusByte{m_status}.moving();
    return m_pwmMayRun || !servo::StatusByte{m_status}.moveDone() || m_velocity.value_or(0) != 0;
}

bool Belief::powered() const {
    return servo::StatusByte{m_status}.powerOn();  // the same bit on both chips
}

StepperMode Belief::stepperMode() const {
    return mayMove() ? m_stepperRun.modeNow(stepper::StatusByte{m_status}) : StepperMode::Stopped;
}

void Belief::mayStart(const servo::LoadTrajectory& load) {
    if (!load.servo) {
        m_pwmMayRun = m_pwmMayRun || load.pwm.value_or(1) != 0;
        return;
    }
    m_mayEnable = true;
    m_velocityReverse = load.reverse;
    // Without a velocity, the chip uses the one loaded before, which is unknown here.
    if (load.profile == servo::ProfileMode::Velocity)
        m_velocityGoal = m_velocityGoal || load.velocity.value_or(CountsPerTick(1)).value() != 0;
}

void Belief::started(const servo::LoadTrajectory& load) {
    m_pwmUnknown = false;
    m_pwmMayRun = !load.servo && load.pwm.value_or(1) != 0;
    m_velocityGoal = load.servo && load.profile == servo::ProfileMode::Velocity &&
                     load.velocity.value_or(CountsPerTick(1)).value() != 0;
    m_starting.reset();
}

}  // namespace nmc::bus
