// SPDX-License-Identifier: MIT
#include "model/scope/commandposition.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/overloaded.h"

namespace nmc {

namespace {

using Phase = ProfileCurve::Phase;

/// Servo ticks after which a command certainly shows in the chip's status: one, and another for safety.
constexpr int kShowsAfter = 2;
/// The maximum distance that a moving motor continues when it is switched on, in ticks of its travel.
constexpr double kRampTicks = 8;

[[nodiscard]] TimePoint showsFrom(const bus::CommandExecuted& executed, Duration tick) {
    return executed.time + std::max(Duration{}, executed.late) + kShowsAfter * tick;
}

[[nodiscard]] CommandEstimate exactly(double position) {
    return {position, position, position};
}

/// The window in which a module latched what the bus reports with this time (bus::Sample).
[[nodiscard]] TickClock::Window windowOf(TimePoint time, Duration late) {
    return {time - kServoTick / 2, time + kServoTick / 2 + bus::kPromptWithin + late};
}

}  // namespace

void CommandPosition::apply(const bus::CommandExecuted& executed) {
    const auto* command = std::get_if<ServoCommand>(&executed.command);
    if (command == nullptr)
        return;
    countTicks(executed.time, executed.late, executed.early);
    m_verified = std::exchange(m_unsettled, false);
    const auto gainsBefore = m_registers.gains;
    m_registers.apply(*command, kFirstServo);
    std::visit(Overloaded{
                   [&](const servo::LoadTrajectory& load) {
                       if (load.startNow)
                           start(executed);
                   },
                   [&](const StartMotion&) { start(executed); },
                   [&](const servo::StopMotor& stopMotor) { stop(stopMotor, executed); },
                   [&](const ResetPosition&) { zero(executed); },
                   [&](const servo::SetGain& gains) {
                       if (gainsBefore != gains)
                           m_standing = {};
                       setServoRate(gains.sr, executed);
                   },
                   [&](const servo::SetHoming& homing) { arm(homing, executed); },
                   [&](const AnyOf<servo::ResetRelativeToHome, servo::SetPosition> auto&) { forget(); },
                   [](const auto& /*other*/) {},
               },
               *command);
}

void CommandPosition::apply(const bus::Sample& sample) {
    countTicks(sample.time, sample.late);
    if (sample.report.aux)
        m_servoOn = servo::AuxByte{*sample.report.aux}.servoOn();
    const servo::StatusByte status{sample.heard.value_or(sample.report.status)};
    m_unsettled = sample.unsettled && m_servoOn;
    if (m_unsettled) {
        m_look = sample;
        return;
    }
    learnHome(sample, status);
    learnContradiction(sample, status);
    if (!m_servoOn)
        switchedOff();
    else if (m_awaiting == Awaiting::HeldPosition || m_awaiting == Awaiting::HeldIfItStood)
        learnHeldPosition(sample);
    // A module that reports its error may be an SC, whose slew bit means "constant speed or stopped".
    else if (sample.report.aux && !sample.report.positionError && sample.time >= m_effective)
        learnProgress(sample, status, servo::AuxByte{*sample.report.aux});
    learnStanding(sample, status);
    if (sample.report.position) {
        m_lastPosition = *sample.report.position;
        m_lastTime = sample.time;
    }
}

void CommandPosition::forget() {
    m_ticks = {};
    m_envelope.reset();
    m_motion = Motion::None;
    m_awaiting = Awaiting::Nothing;
    m_strange.reset();
    m_unsettled = false;
    m_lastPosition.reset();
}

void CommandPosition::contradicted() {
    m_envelope.reset();
    if (m_motion == Motion::Trapezoid)
        m_awaiting = Awaiting::EndOfMove;
    m_motion = Motion::None;
}

void CommandPosition::doubtServoRate() {
    if (m_motion != Motion::None)
        forget();
    m_tick = kServoTick * servo::kServoRateRange.max;
    m_tickKnown = false;
}

void CommandPosition::attached() {
    doubtServoRate();
    m_registers.velocity.reset();
    m_registers.acceleration.reset();
}

/// DS-V 4.5: velocity and acceleration are 0.
ServoRegisters CommandPosition::afterPowerUp() {
    ServoRegisters registers;
    registers.acceleration = CountsPerTickSquared(0);
    return registers;
}

void CommandPosition::cancelled() {
    if (m_unsettled)
        forget();
}

std::optional<CommandEstimate> CommandPosition::at(TimePoint time, Duration late) const {
    if (!m_envelope || m_unsettled || (m_strange && time >= *m_strange))
        return std::nullopt;
    return m_envelope->at(shown(time, late));
}

void CommandPosition::countTicks(TimePoint time, Duration late, Duration early) {
    if (early > Duration{})
        return;
    const bool moves = m_envelope && m_motion != Motion::None;
    const bool counted = m_ticks.counts();
    m_ticks.learn(windowOf(time, late), !moves);
    m_lostCount = moves && (m_lostCount || (counted && !m_ticks.counts()));
}

Moments CommandPosition::latched(TimePoint time, Duration late, Duration early) const {
    const TickClock::Window window = windowOf(time, late);
    const TimePoint first = window.earliest - early;
    // A status about which nothing more is known was most likely prompt and not repeated.
    if (const auto ticks = m_ticks.ticksIn(window))
        return {m_ticks.ticksIn({first, window.latest})->earliest,
                ticks->earliest + std::min(kServoTick, ticks->latest - ticks->earliest) / 2, ticks->latest,
                0.0};
    // The motion began by the module's clock, which may differ from this one by up to a tick.
    const Duration between = m_lostCount ? kServoTick : Duration{};
    return {first - between, window.earliest + std::min(kServoTick, window.latest - window.earliest) / 2,
            window.latest + between};
}

Moments CommandPosition::shown(TimePoint time, Duration late, Duration early) const {
    const Moments tick = latched(time, late, early);
    return {tick.earliest + kServoTick - m_tick / 2, tick.likely + kServoTick / 2, tick.latest + m_tick / 2,
            tick.apart};
}

Moments CommandPosition::begun(const bus::CommandExecuted& executed) const {
    const Moments tick = latched(executed.time, executed.late, executed.early);
    const Duration longer = m_tick - kServoTick;
    return {tick.earliest - longer, tick.likely - longer / 2, tick.latest, tick.apart};
}

// ---- Commands ----

void CommandPosition::start(const bus::CommandExecuted& executed) {
    if (!m_envelope)
        return startAs(executed);
    const double from = m_envelope->at(shown(executed)).position;
    startAs(executed);
    if (!m_verified || !m_envelope || !m_look || !m_look->report.position)
        return;
    // The status reads take a shaft for started even when it was only nudged. If it has covered less than
    // half the distance by then, the module may not have received the start.
    const double there = m_envelope->at(shown(m_look->time, m_look->late)).position;
    if (std::abs(*m_look->report.position - there) > std::abs(there - from) / 2)
        forget();
}

void CommandPosition::startAs(const bus::CommandExecuted& executed) {
    commanded(executed);
    const servo::LoadTrajectory load = m_registers.trajectory();
    const double velocity = toCounts(load.velocity.value_or(CountsPerTick()));
    if (!load.servo)
        return switchedOff();
    m_servoOn = true;
    m_runningAcceleration = toCounts(load.acceleration.value_or(CountsPerTickSquared()));
    m_runningGoal = load.position ? load.position->value() : 0;
    // For a shaft that was already moving, its motion does not show whether the new command was executed.
    if (m_verified && m_motion != Motion::None)
        return forget();
    if (!load.velocity || !load.acceleration)
        m_envelope.reset();
    if (m_envelope && m_motion == Motion::None)
        m_standing.leave(m_envelope->at(shown(executed)));
    const Moments when = begun(executed);
    if (load.profile == servo::ProfileMode::Velocity) {
        m_awaiting = Awaiting::Nothing;
        return runAt(load.reverse ? -velocity : velocity, when);
    }
    if (load.relative)
        return forget();  // a module with relative moves reports its error, so this is not needed
    const auto from = m_tickKnown ? at(executed.time, executed.late) : std::nullopt;
    if (!m_tickKnown)
        m_envelope.reset();
    m_awaiting = from ? Awaiting::Nothing : Awaiting::EndOfMove;
    if (!from)
        return;
    rest(*from);
    m_motion = Motion::Trapezoid;
    m_envelope->moveTo(m_runningGoal, velocity, {tick(), m_runningAcceleration}, when);
}

void CommandPosition::runAt(double velocity, const Moments& when) {
    if (!m_tickKnown && (m_motion != Motion::None || velocity != 0.0))
        m_envelope.reset();
    m_motion = Motion::Velocity;
    m_runningVelocity = velocity;
    if (m_awaiting == Awaiting::EndOfMove)
        m_awaiting = Awaiting::Nothing;
    if (m_envelope)
        m_envelope->changeVelocity(velocity, {tick(), m_runningAcceleration}, when);
}

void CommandPosition::stop(const servo::StopMotor& stop, const bus::CommandExecuted& executed) {
    if (stop.manner == servo::StopManner::AmplifierOnly)
        return;
    commanded(executed);
    const bool wasOn = std::exchange(m_servoOn, true);
    if (stop.manner == servo::StopManner::MotorOff)
        switchedOff();
    else if (stop.manner == servo::StopManner::Here)
        rest(exactly(stop.here.value()));
    else if (!wasOn)
        m_awaiting =
            stop.manner == servo::StopManner::Smoothly ? Awaiting::HeldIfItStood : Awaiting::HeldPosition;
    else if (stop.manner == servo::StopManner::Smoothly)
        runAt(0.0, begun(executed));
    else
        freeze(shown(executed));
}

/// Position and command position become 0; the goal of a completed move loses its meaning.
void CommandPosition::zero(const bus::CommandExecuted& executed) {
    m_lastPosition.reset();
    if (m_awaiting == Awaiting::EndOfMove)
        m_awaiting = Awaiting::Nothing;
    if (m_motion == Motion::Trapezoid)
        m_motion = Motion::None;
    if (m_envelope)
        m_envelope->makeZero({tick(), m_runningAcceleration}, shown(executed));
}

void CommandPosition::arm(const servo::SetHoming& homing, const bus::CommandExecuted& executed) {
    using servo::StopManner;
    m_homing.reset();
    if (!homing.watches())
        return;
    const StopManner manner = homing.motorOff       ? StopManner::MotorOff
                              : homing.stopAbruptly ? StopManner::Abruptly
                                                    : StopManner::Smoothly;
    if (homing.motorOff || homing.stopAbruptly || homing.stopSmoothly)
        m_homing = HomingStop{manner, showsFrom(executed, kServoTick), shown(executed)};
}

void CommandPosition::setServoRate(std::uint8_t divisor, const bus::CommandExecuted& executed) {
    const Duration old = m_tick;
    const Moments before = begun(executed);
    m_tick = kServoTick * divisor;
    m_tickKnown = true;
    m_effective = std::max(m_effective, showsFrom(executed, m_tick));
    // The chip counts per tick, so with a longer tick it runs the same profile more slowly from here on.
    // Where a servo tick is longer than the base tick, setting the gains may restart it.
    if (m_envelope && (m_tick != old || divisor > 1))
        m_envelope->stretch(toSeconds(m_tick) / toSeconds(old), before, begun(executed));
}

void CommandPosition::switchedOff() {
    m_envelope.reset();
    m_motion = Motion::None;
    m_awaiting = Awaiting::Nothing;
    m_strange.reset();
    m_servoOn = false;
}

void CommandPosition::rest(const CommandEstimate& held) {
    m_envelope = CommandEnvelope(held);
    m_motion = Motion::None;
    m_awaiting = Awaiting::Nothing;
    m_strange.reset();
}

/// Stands still at the position at that time, if it is known.
void CommandPosition::freeze(const Moments& when) {
    m_motion = Motion::None;
    if (m_awaiting == Awaiting::EndOfMove)
        m_awaiting = Awaiting::Nothing;
    if (m_envelope)
        m_envelope = CommandEnvelope(m_envelope->at(when));
}

// ---- Status from the module ----

void CommandPosition::learnHome(const bus::Sample& sample, servo::StatusByte status) {
    if (!m_homing || sample.time < m_homing->shows)
        return;
    const Moments now = shown(sample.time, sample.late);
    if (status.homeInProgress())
        m_homing->searching = now;
    else
        stopAtHome({m_homing->searching.earliest,
                    m_homing->searching.likely + (now.likely - m_homing->searching.likely) / 2, now.latest,
                    std::max(m_homing->searching.apart, now.apart)},
                   sample.time + std::max(Duration{}, sample.late) + kShowsAfter * m_tick);
}

/// The moment of the stop is only known to lie between two statuses.
void CommandPosition::stopAtHome(const Moments& found, TimePoint shows) {
    const servo::StopManner manner = std::exchange(m_homing, std::nullopt)->manner;
    if (manner == servo::StopManner::MotorOff)
        return;  // the status reports that the servo is off
    m_registers.stopped(manner, kFirstServo);
    m_effective = shows;
    if (manner == servo::StopManner::Smoothly)
        runAt(0.0, {found.earliest - m_tick / 2, found.likely - m_tick / 2, found.latest - m_tick / 2,
                    found.apart});
    else
        freeze(found);
}

/// The answer to the command reports the position at that moment. Later the motor may have moved on.
void CommandPosition::learnHeldPosition(const bus::Sample& sample) {
    if (!sample.report.position)
        return;
    const double now = *sample.report.position;
    // Velocity mode is entered at the motor's velocity (DS-V 4.5), from which a smooth stop has a way to go.
    if (m_awaiting == Awaiting::HeldIfItStood && m_lastPosition != now) {
        m_awaiting = Awaiting::Nothing;
        return;
    }
    const bool atOnce = sample.time == m_commanded && !m_repeated;
    const double last = m_lastPosition.value_or(now);
    const double before = atOnce ? now : last;
    // A moving motor continues for a while, and not evenly.
    const double travelled = atOnce && m_lastPosition ? std::abs(now - last) : 0.0;
    const double perTick = travelled == 0.0 ? 0.0 : travelled / toSeconds(sample.time - m_lastTime) * tick();
    const double more = std::floor(kRampTicks * perTick);
    rest({(now + before) / 2, std::min(now, before) - more, std::max(now, before) + more});
}

/// At rest, move_done is set (DS-V 5.3).
void CommandPosition::learnContradiction(const bus::Sample& sample, servo::StatusByte status) {
    const bool rests = m_envelope && m_motion == Motion::None;
    if (rests && !m_strange && !status.moveDone() && sample.time >= m_effective)
        m_strange = sample.time;
}

/// A command executed before the unexplained motion began explains it. Otherwise the motion leads to an
/// unknown position.
void CommandPosition::commanded(const bus::CommandExecuted& executed) {
    if (m_strange && executed.time >= *m_strange)
        m_envelope.reset();
    m_strange.reset();
    m_commanded = executed.time;
    m_repeated = executed.early > Duration{};
    m_effective = showsFrom(executed, m_tick);
}

/// DS-V 5.3: move_done is clear during a trapezoidal move and while one velocity changes into another;
/// accel_done and slew_done are valid for trapezoidal moves only.
void CommandPosition::learnProgress(const bus::Sample& sample, servo::StatusByte status, servo::AuxByte aux) {
    // The end of a move permits further actions, so one reply is not enough.
    const bool done = status.moveDone() && servo::StatusByte{sample.report.status}.moveDone();
    if (done && (m_motion == Motion::Trapezoid || m_awaiting == Awaiting::EndOfMove))
        return rest(exactly(m_runningGoal));
    if (!m_envelope || m_motion == Motion::None)
        return;
    // A phase ends with the first step at or after its end, which the curve passes half a tick later; a chip
    // may count one step more or less.
    const Moments now = shown(sample.time, sample.late);
    const auto learn = [&](Phase phase, bool over) {
        return over ? m_envelope->ended(phase, now.latest + m_tick / 2)
                    : m_envelope->goesOn(phase, now.earliest - 2 * m_tick);
    };
    if (m_motion == Motion::Trapezoid) {
        learn(Phase::Acceleration, aux.accelDone());
        learn(Phase::Slew, aux.slewDone());
    }
    // A trapezoid ends at its goal whenever it began. Any other motion that began at a different moment, or
    // is a different motion, may be anywhere.
    if (done != status.moveDone())
        return;
    if (!learn(Phase::Last, done) && m_motion == Motion::Velocity)
        return m_envelope.reset();
    // A stop has ended: the command position rests, and whatever starts it again is a new motion.
    if (m_motion == Motion::Velocity && m_runningVelocity == 0.0 && done) {
        const TimePoint stands = now.latest + kShowsAfter * m_tick;
        rest(m_envelope->at({stands, stands, stands, now.apart}));
    }
}

/// At rest, the shaft's position may narrow the band of the command position.
void CommandPosition::learnStanding(const bus::Sample& sample, servo::StatusByte status) {
    const bool rests = m_envelope && m_motion == Motion::None && !m_strange;
    if (!rests || !sample.report.position || sample.time < m_effective)
        return m_standing.move();
    const Moments now = shown(sample.time, sample.late);
    if (const auto narrower =
            m_standing.look(sample.time, *sample.report.position, !status.moveDone(), m_envelope->at(now)))
        m_envelope = CommandEnvelope(*narrower);
}

}  // namespace nmc
