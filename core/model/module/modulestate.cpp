// SPDX-License-Identifier: MIT
#include "model/module/modulestate.h"

#include <cmath>
#include <cstdlib>

#include "bus/standstill.h"
#include "module/commandfacts.h"

namespace nmc {

/// Detects motion of a motor that is off or was set in motion by another host: a velocity below one count per
/// tick reads 0, so only the position shows it.
void ModuleState::watchDrift(const bus::Sample& sample, bool wasOn) {
    constexpr Duration kLately = std::chrono::seconds(1);
    if (!servoOn())
        m_motionUnknown = false;
    if (wasOn && !servoOn()) {
        m_restedAt.reset();
        m_drifts = false;
    }
    if (!sample.report.position)
        return;
    if (!m_restedAt || !samePlace(*m_restedAt->report.position, *sample.report.position)) {
        m_drifts = m_restedAt.has_value();
        if (m_drifts)
            m_changedPlaceAt = sample.time;
        m_restedAt = sample;
    } else if (sample.time - m_restedAt->time > kLately) {
        m_drifts = false;
    }
}

void ModuleState::apply(const bus::Sample& sample) {
    // Commanded, or seen twice: a single reply may come from another module, which another host has queried.
    const bool wasOn = servoOn() && (m_looksWhileOn > 1 || motion != MotionMode::None);
    const bool wasMoving = moving();
    m_restConfirmed = false;
    const HomeWatch watchBefore = homing;
    if (!latest)
        latest.emplace();
    merge(info.identity, *latest, sample.report);
    latestTime = sample.time;
    if (sample.jumped) {
        m_jumpedAt = sample.time;
        speed.forget();
    }
    if (sample.report.position)
        speed.apply(sample.time, *sample.report.position);
    if (sample.report.counter)
        counting.apply(sample.time, static_cast<std::int32_t>(*sample.report.counter));
    home.apply(sample);
    const bool homeFound = watchHome(sample);
    const std::optional<Activity> endedBefore = stepper.ended();
    if (isStepper()) {
        stepper.apply(*latest, sample.time, homeFound);
        switchedItselfOff = stepper.offByItself();
        powerLostWhileOn = switchedItselfOff && stepper.activity() == Activity::PowerLost;
    }
    endAtLimit();
    watchLimits(wasMoving, watchBefore, endedBefore);
    if (!isServo() || !latest->aux)
        return;
    if (!sample.report.aux)  // another program may not ask for it
        return watchDrift(sample, wasOn);
    if (sample.report.position && m_held) {
        const std::int64_t off = countsBetween(m_held->stood, *sample.report.position);
        if (servoOn() && std::abs(off) <= m_held->within)
            m_goal = m_held->goal;
        m_held.reset();
    }
    watchPath(sample.report);
    m_looksWhileOn = servoOn() ? m_looksWhileOn + 1 : 0;
    watchDrift(sample, wasOn);
    if (servoOn()) {
        switchedItselfOff = powerLostWhileOn = false;
        m_looksWhileOff = 0;
    } else if (wasOn && !offCommanded) {
        maybeWentOff(homing.state() == HomeWatch::State::Armed && homing.switchesOff() &&
                     latest->servoStatus().powerOn());
    } else if (m_looksWhileOff > 0 && ++m_looksWhileOff == m_looksToBeOff) {
        wentOff();
    }
    if (latest->position)
        m_trip.apply(tripLook());
    if (!servoOn() || moving() || sample.time - motionCommandedAt < SwingWatch::kCalm)
        swing.forget();
    else if (sample.report.position)
        swing.look(sample.time, *sample.report.position);
}

/// The servo holds the position where a path has ended.
void ModuleState::watchPath(const StatusReport& report) {
    if (const auto commanded = report.commandPosition())
        m_commandPosition = commanded;
    if (motion != MotionMode::Path || moving())
        return;
    motion = MotionMode::None;
    m_goal = m_commandPosition;
}

/// A single reply may come from another module, or be damaged. `byHome`: homing may have switched the motor
/// off, and whether home was found shows only two replies later (bus/trust.h).
void ModuleState::maybeWentOff(bool byHome) {
    constexpr unsigned kLooks = 2;
    constexpr unsigned kLooksAtHome = 4;
    m_looksWhileOff = 1;
    m_looksToBeOff = byHome ? kLooksAtHome : kLooks;
    m_causeSeen = causeOfTrip();
}

/// Uses the present reply: in later ones the motor is already coasting.
TripCause ModuleState::causeOfTrip() const {
    const bool limitsSwitchOff = scIo && scIo->limitStop == servo::LimitStop::MotorOff;
    for (const int way : {1, -1})
        if (limitsSwitchOff && limitEnds(way) && direction() != -way)
            return way > 0 ? TripCause::OffAtLimit1 : TripCause::OffAtLimit2;
    const auto facts = gains && latest->position ? m_trip.facts(tripLook(), gains->el) : std::nullopt;
    return facts ? diagnose(*facts) : TripCause::Unknown;
}

void ModuleState::wentOff() {
    m_looksWhileOff = 0;
    m_goal.reset();
    switchedItselfOff = true;
    tripCause = m_causeSeen;
    powerLostWhileOn = !latest->servoStatus().powerOn();
    motion = MotionMode::None;
}

TripWatch::Reading ModuleState::tripLook() const {
    const auto [limit1, limit2] = closedLimits();
    return {latestTime, *latest->position, limit1, limit2};
}

/// Limits of a PIC-STEP that are set to be ignored count as open.
LimitWatch::Limits ModuleState::closedLimits() const {
    if (isStepper())
        return {stepper.limitActs(false), stepper.limitActs(true)};
    const servo::StatusByte status = latest->servoStatus();
    return {status.limit1() && (!io || io->limit1IsInput), status.limit2() && (!io || io->limit2IsInput)};
}

int ModuleState::direction() const {
    if (motion == MotionMode::Velocity)
        return goalVelocity < 0 ? -1 : goalVelocity > 0 ? 1 : 0;
    return motion == MotionMode::Trapezoidal && m_goalReverse ? (*m_goalReverse ? -1 : 1) : 0;
}

bool ModuleState::limitEnds(int direction) const {
    return direction != 0 && isServo() && latest &&
           ServoRegisters::limitEnds(latest->servoStatus(), direction < 0);
}

/// The chip has stopped by itself: it holds there, and the loaded goal is no longer reached.
void ModuleState::endedByChip(servo::StopManner manner) {
    motion = MotionMode::Velocity;
    goalVelocity = 0.0;
    stopped(manner, info.identity);
    m_goal.reset();
}

void ModuleState::endAtLimit() {
    if (servoOn() && latest->servoStatus().moveDone() && limitEnds(direction()))
        endedByChip(servo::StopManner::Abruptly);
}

bool ModuleState::stoppedByLimitStop() const {
    if (homing.state() == HomeWatch::State::Tripped)
        return homing.stops() && (homing.onLimit1() || homing.onLimit2());
    return (homing.trippedBeforeAtLimit1() && closedLimits()[0]) ||
           (homing.trippedBeforeAtLimit2() && closedLimits()[1]);
}

void ModuleState::watchLimits(bool wasMoving, const HomeWatch& before, std::optional<Activity> endedBefore) {
    if (!isServo() && !isStepper())
        return;
    const bool watched = before.state() == HomeWatch::State::Armed;
    const bool ended = stepper.ended() == Activity::StoppedByLimit && endedBefore != Activity::StoppedByLimit;
    limits.apply({.closed = closedLimits(),
                  .moves = wasMoving || moving(),
                  .ended = isStepper() && ended,
                  .expected = {watched && before.onLimit1(), watched && before.onLimit2()}});
}

/// Call before the command has changed any state here.
void ModuleState::noteCommand(TimePoint time, int direction, double countsPerTick) {
    const double perSecond = servoRate ? ticksPerSecond(*servoRate) : 0.0;
    m_trip.apply({time, !servoOn(), !moving(), direction, std::abs(countsPerTick) * perSecond});
}

/// Handles a stop or switch-off by the chip itself that was requested by Set Homing Mode (DS-V 5.2,
/// DS-S 5.1). Returns true when this sample shows that home was just found.
bool ModuleState::watchHome(const bus::Sample& sample) {
    const bool found = homing.apply(sample);
    if (found && isStepper() && homing.stops()) {
        stepper.StepperRegisters::stopped(homing.manner() == StopManner::Smoothly
                                              ? stepper::StopManner::Smoothly
                                              : stepper::StopManner::Abruptly);
        loadWaiting = false;
    }
    if (!found || !isServo())
        return found;
    if (homing.stops()) {
        endedByChip(homing.manner() == StopManner::Off ? servo::StopManner::MotorOff
                                                       : servo::StopManner::Abruptly);
        // An abrupt or a smooth stop switches on a servo that is off, as by command.
        offCommanded = offCommanded && homing.switchesOff();
    }
    const bool off = sample.report.aux && !servo::AuxByte{*sample.report.aux}.servoOn();
    if (off && homing.switchesOff()) {
        offCommanded = true;
        switchedItselfOff = false;
        m_looksWhileOff = 0;
        motion = MotionMode::None;
    }
    return true;
}

void ModuleState::apply(const bus::CommandExecuted& executed) {
    m_restConfirmed = false;
    homing.apply(executed);
    home.apply(executed);
    speed.apply(executed);
    if (setsCounter(executed.command))
        forgetLoad();
    if (const auto* step = std::get_if<StepperCommand>(&executed.command)) {
        stepper.apply(*step, executed.time);
        amplifierEnabled = stepper.amplifierOn();
        loadWaiting = stepper.waiting.has_value();
    }
    if (const auto* ioCommand = std::get_if<IoCommand>(&executed.command)) {
        pins.apply(*ioCommand);
        if (std::holds_alternative<io::SetTimerMode>(*ioCommand))
            counting.forget();  // the count was cleared
    }
    const auto* command = std::get_if<ServoCommand>(&executed.command);
    if (command == nullptr)
        return;
    if (const auto* set = std::get_if<servo::SetGain>(command)) {
        if (!executed.ofTrial) {
            if (m_gainsSet && *m_gainsSet != *set)
                gainsBefore = m_gainsSet;
            m_gainsSet = *set;
        }
        swing.forget();
    }
    ServoRegisters::apply(*command, info.identity);
    if (is<StartMotion>(executed.command) || (is<servo::LoadTrajectory>(executed.command) && !loadWaiting)) {
        applyLoaded(executed.time);
    } else if (const auto* stop = std::get_if<servo::StopMotor>(command)) {
        apply(*stop, executed.time);
    } else if (const auto* add = std::get_if<servo::AddPathPoints>(command)) {
        if (add->startsPath())
            commanded(MotionMode::Path, executed.time);
    } else if (setsCounter(executed.command)) {
        m_goal.reset();
        m_held.reset();
        m_restedAt.reset();
        m_drifts = false;
        m_trip.forget();
    }
}

void ModuleState::restarted() {
    hasRestarted = true;
    stopUnconfirmed = false;
    static_cast<ServoRegisters&>(*this) = {};
    speed.forget();
    counting.forget();
    swing.forget();
    gainsBefore.reset();
    m_gainsSet.reset();
    m_commandPosition.reset();
    homing = {};
    limits = {};
    home.restarted();
    m_held.reset();
    m_goal.reset();
    m_looksWhileOff = 0;
    motion = MotionMode::None;
    goalVelocity = 0.0;
    stepper.restarted();
    pins = {};
}

void ModuleState::attached() {
    m_motionUnknown = isServo();
    amplifierEnabled.reset();
    velocity.reset();
    servoRate.reset();
    pathControl.reset();
    stepper.attached();
    pins.attached();
}

void ModuleState::doubtMotion() {
    m_drifts = m_drifts || moving();
    m_motionUnknown = isServo();
}

void ModuleState::doubtGains() {
    gains.reset();
    servoRate.reset();
}

void ModuleState::confirmedAtRest() {
    stopUnconfirmed = false;
    m_restConfirmed = true;
    motion = motion == MotionMode::Velocity ? motion : MotionMode::None;
    goalVelocity = 0.0;
    stopped(servoOn() ? servo::StopManner::Abruptly : servo::StopManner::MotorOff, info.identity);
    m_motionUnknown = m_drifts = false;
    m_restedAt.reset();
    // A stop whose answer was lost may have cut a move short. The outcome of a stop that was carried out is
    // known.
    if (motion != MotionMode::Velocity)
        m_goal.reset();
}

void ModuleState::commanded(MotionMode mode, TimePoint time) {
    motionCommandedAt = time;
    motion = mode;
    goalVelocity = 0.0;
    offCommanded = mode == MotionMode::None || mode == MotionMode::Pwm;
    // Switching the motor off, or driving it by PWM, implies that the user has noticed that it is off, so it
    // acknowledges an earlier trip.
    if (offCommanded) {
        switchedItselfOff = powerLostWhileOn = false;
        m_looksWhileOff = 0;
    }
    m_motionUnknown = m_motionUnknown && mode == MotionMode::Pwm;
    m_goal.reset();
    m_goalReverse.reset();
    m_held.reset();
}

void ModuleState::applyLoaded(TimePoint time) {
    const std::optional<std::int32_t> from = goal();
    const servo::LoadTrajectory started = trajectory();
    if (!started.servo)
        return commanded(MotionMode::Pwm, time);
    const double magnitude = toCounts(started.velocity.value_or(CountsPerTick()));
    const bool reverse = started.isVelocityMode() ? started.reverse
                         : started.relative       ? started.position && started.position->value() < 0
                                                  : latest && latest->position && started.position &&
                                                  started.position->value() < *latest->position;
    noteCommand(time, magnitude == 0.0 ? 0 : reverse ? -1 : 1, magnitude);
    commanded(started.isVelocityMode() ? MotionMode::Velocity : MotionMode::Trapezoidal, time);
    goalVelocity = started.reverse ? -magnitude : magnitude;
    // If another host has loaded the velocity, only the position shows whether the motor moves.
    m_motionUnknown = started.isVelocityMode() && !started.velocity;
    if (started.isVelocityMode() || !started.position)
        return;
    if (!started.relative)
        m_goal = started.position->value();
    else if (from)
        m_goal = static_cast<std::int32_t>(std::int64_t{*from} + started.position->value());  // it wraps
    m_goalReverse = reverse;
}

void ModuleState::apply(const servo::StopMotor& stop, TimePoint time) {
    if (stop.manner == servo::StopManner::AmplifierOnly)
        return;
    const bool off = stop.manner == servo::StopManner::MotorOff;
    const bool here = stop.manner == servo::StopManner::Here;
    if (!off)
        noteCommand(time, 0, 0.0);
    const auto held = off || here ? std::nullopt : heldThroughStop();
    commanded(off ? MotionMode::None : MotionMode::Velocity, time);
    m_held = held;
    if (here)
        m_goal = stop.here.value();
    m_looksWhileOff = 0;
}

/// DS-V 5.2, Stop Motor: a servo switched on by a stop holds its present position. A servo already at rest
/// continues to hold its goal, which may differ from its present position.
std::optional<ModuleState::Held> ModuleState::heldThroughStop() const {
    const auto stood = position();
    if (!stood)
        return std::nullopt;
    if (!servoOn())
        return Held{*stood, *stood, 0};
    // A move may have begun since the last status; a stop leaves nothing that could begin.
    const bool rests = !moving() && !m_motionUnknown &&
                       (motion == MotionMode::Velocity || latestTime - motionCommandedAt > SwingWatch::kCalm);
    if (!rests || !m_goal)
        return m_held;
    return Held{*m_goal, *stood, kStillCounts};
}

bool ModuleState::servoOn() const {
    return isServo() && !hasRestarted && latest && latest->aux && servo::AuxByte{*latest->aux}.servoOn();
}

bool ModuleState::currentWasLimited() const {
    return isServo() && latest && latest->servoStatus().overcurrent();
}

std::optional<std::int32_t> ModuleState::goal() const {
    if (isServo())
        return !servoOn() ? std::nullopt : m_goal || moving() ? m_goal : m_commandPosition;
    if (!isStepper())
        return std::nullopt;
    const bool held = stepper.moving() || stepper.position() == stepper.goal();
    return stepper.amplifierOn() && held ? stepper.goal() : std::optional<std::int32_t>();
}

std::optional<bool> ModuleState::goalReverse() const {
    if (!goal())
        return std::nullopt;
    return isStepper() ? stepper.lastReverse() : m_goalReverse;
}

bool ModuleState::headsFor(std::int32_t goal) const {
    return isStepper() ? stepper.goal() == goal : motion == MotionMode::Trapezoidal && this->goal() == goal;
}

bool ModuleState::positionDoubtful() const {
    // An unreliable line counts as well again after this long without a misdirected reply.
    constexpr Duration kWell = std::chrono::seconds(2);
    return m_jumpedAt && latestTime - *m_jumpedAt < kWell;
}

bool ModuleState::driveOn() const {
    return isStepper() ? stepper.amplifierOn() : servoOn();
}

bool ModuleState::onPath() const {
    return servoOn() && hasPathBuffer(info.identity) && servo::AuxByte{*latest->aux}.pathMode();
}

bool ModuleState::moving() const {
    if (!latest || hasRestarted)
        return false;
    if (isStepper())
        return stepper.moving();
    if (!isServo())
        return false;
    if (!servoOn())
        return motion == MotionMode::Pwm;
    if (!latest->servoStatus().moveDone() || onPath())
        return true;
    return m_motionUnknown ? m_drifts : motion == MotionMode::Velocity && goalVelocity != 0.0;
}

Activity ModuleState::activity() const {
    if (hasRestarted)
        return Activity::Restarted;
    if (silent)
        return notAsked ? Activity::NotAsked : Activity::Unresponsive;
    if (isStepper() && latest)
        return stepper.activity();
    if (isIo() && latest)
        return Activity::Ready;
    if (!isServo() || !latest || !latest->aux)
        return Activity::Unknown;
    return servoOn() ? activityWhileOn() : activityWhileOff();
}

Activity ModuleState::activityWhileOff() const {
    if (powerLostWhileOn)
        return Activity::PowerLost;
    if (switchedItselfOff)
        return Activity::Tripped;
    if (m_looksWhileOff == 1)
        return Activity::MaybeOff;
    // Without power, too: when it returns, the value may drive the motor again (docs/protocol.md, section 2).
    if (motion == MotionMode::Pwm)
        return Activity::PwmMode;
    if (!latest->servoStatus().powerOn())
        return Activity::NoPower;
    return turns() ? Activity::Turned : Activity::ServoOff;
}

/// A motor whose position changes more rarely than this is not at speed.
bool ModuleState::changedPlaceLately() const {
    constexpr Duration kLately = std::chrono::milliseconds(250);
    return m_changedPlaceAt && latestTime - *m_changedPlaceAt <= kLately;
}

Activity ModuleState::activityWhileOn() const {
    if (onPath())
        return Activity::OnPath;
    if (latest->servoStatus().moveDone()) {
        if (moving())
            return m_motionUnknown && !changedPlaceLately() ? Activity::MaybeMoving : Activity::AtSpeed;
        return currentWasLimited() ? Activity::Limited : Activity::Holding;
    }
    if (motion == MotionMode::Velocity && !m_motionUnknown)
        return goalVelocity == 0.0 ? Activity::Decelerating : Activity::Accelerating;
    const servo::AuxByte aux{*latest->aux};
    if (!aux.accelDone())
        return Activity::Accelerating;
    return aux.slewDone() ? Activity::Decelerating : Activity::AtSpeed;
}

}  // namespace nmc
