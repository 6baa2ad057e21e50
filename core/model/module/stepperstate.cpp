// SPDX-License-Identifier: MIT
#include "model/module/stepperstate.h"

#include <utility>

namespace nmc {

void StepperState::attached() {
    outputs.reset();
}

void StepperState::restarted() {
    *this = StepperState{};
    outputs.reset();
}

// ---- Status ----

void StepperState::apply(const StatusReport& latest, TimePoint time, bool homeFound) {
    const bool wasMoving = moving();
    const bool wasOn = m_on;
    m_status = latest.stepperStatus();
    m_inputs = {latest.aux.value_or(0)};
    m_analog = latest.analog;
    m_position = latest.position;
    if (m_startedAt && time > *m_startedAt)
        m_startedAt.reset();
    if (!m_switchedAt || time > *m_switchedAt) {
        m_switchedAt.reset();
        m_on = m_status.amplifierEnabled();
        watchAmplifier(wasOn);
    }
    // A smaller count means a slower timer.
    m_slowing = m_timer && latest.timerCount && *latest.timerCount < *m_timer;
    m_timer = latest.timerCount;
    watchMotion(wasMoving, homeFound);
}

void StepperState::watchAmplifier(bool wasOn) {
    if (m_on) {
        m_offOnce = false;
        if (std::exchange(m_offByItself, false))
            m_ended.reset();  // it was another module's reply, or an old one
        return;
    }
    if (m_offCommanded || !(wasOn || m_offOnce))
        return;
    const bool homeFound = m_homingSwitchesOff && !m_status.homing();
    m_homingSwitchesOff = m_homingSwitchesOff && !homeFound;
    m_offOnce = !m_offOnce && !homeFound;
    if (homeFound)
        return;
    if (m_offOnce) {
        m_offCause = whatActs();
        return;
    }
    m_offByItself = true;
    m_ended = m_offCause ? *m_offCause : whatActs().value_or(Activity::WentOff);
}

/// What may have switched the amplifier off, most serious first.
std::optional<Activity> StepperState::whatActs() const {
    if (!powered())
        return Activity::PowerLost;
    if (tooHot())
        return Activity::Overheated;
    if (estopActs())
        return Activity::EstopActive;
    if (limitActs(false) || limitActs(true))
        return Activity::StoppedByLimit;
    return std::nullopt;
}

/// A switch that homing watched for is home, and not a limit that was run into.
void StepperState::watchMotion(bool wasMoving, bool homeFound) {
    if (moving())
        return;
    m_stopping = false;
    if (!wasMoving || homeFound || m_ourStop || m_offByItself || (m_run.goal && m_position == m_run.goal))
        return;
    if (estopActs())
        m_ended = Activity::EstopActive;
    else if (limitActs(m_run.reverse.value_or(false)))
        m_ended = Activity::StoppedByLimit;
}

bool StepperState::estopActs() const {
    return m_inputs.estop() && !(parameters && parameters->ignoreEstop);
}

bool StepperState::limitActs(bool reverse) const {
    const bool active = reverse ? m_inputs.limit2() : m_inputs.limit1();
    return active && !(parameters && parameters->ignoreLimits);
}

bool StepperState::tooHot() const {
    return parameters && m_analog && *m_analog < parameters->thermalLimit;
}

StepperMode StepperState::mode() const {
    if (!moving())
        return StepperMode::Stopped;
    // After a start, the status is still that of the motion before.
    return m_startedAt ? m_run.mode.value_or(StepperMode::Unknown) : m_run.modeNow(m_status);
}

Activity StepperState::activity() const {
    if (!powered())
        return m_ended == Activity::PowerLost ? Activity::PowerLost : Activity::NoPower;
    if (!m_on)
        return m_ended       ? *m_ended
               : m_offOnce   ? Activity::MaybeOff
               : estopActs() ? Activity::EstopActive
                             : Activity::AmplifierOff;
    if (!moving())
        return estopActs() ? Activity::EstopActive : m_ended.value_or(Activity::Holding);
    if (m_startedAt)
        return Activity::Accelerating;
    if (m_stopping)
        return Activity::Decelerating;
    if (m_status.atSpeed())
        return Activity::AtSpeed;
    return m_slowing ? Activity::Decelerating : Activity::Accelerating;
}

// ---- Commands ----

struct StepperState::Executed {
    StepperState& s;
    TimePoint time;

    void operator()(const stepper::LoadTrajectory& load) const {
        if (load.startNow)
            s.started(load, time);
    }
    void operator()(const StartMotion&) const {
        if (s.waiting)
            s.started(*s.waiting, time);
    }
    void operator()(const stepper::StopMotor& stop) const { s.stopped(stop, time); }
    void operator()(const stepper::SetHoming& homing) const {
        s.m_homingSwitchesOff = homing.watches() && homing.motorOff;
    }
    void operator()(const auto& /*other*/) const {}
};

void StepperState::apply(const StepperCommand& executed, TimePoint time) {
    std::visit(Executed{*this, time}, executed);
    StepperRegisters::apply(executed);
}

void StepperState::started(const stepper::LoadTrajectory& load, TimePoint time) {
    m_run.start(load, mode(), m_position);
    m_startedAt = time;
    m_stopping = m_ourStop = m_slowing = false;
    m_ended.reset();
}

void StepperState::stopped(const stepper::StopMotor& stop, TimePoint time) {
    m_on = stop.amplifierEnable;
    m_switchedAt = time;
    m_offCommanded = !stop.amplifierEnable;
    // Stopping or switching the motor implies that the user has noticed what happened before.
    m_offByItself = m_offOnce = false;
    m_ended.reset();
    if (stop.manner == stepper::StopManner::AmplifierOnly)
        return;
    m_startedAt.reset();
    m_ourStop = true;
    m_stopping = stop.manner == stepper::StopManner::Smoothly;
}

}  // namespace nmc
