// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/time.h"
#include "bus/types.h"
#include "model/module/activity.h"
#include "model/module/homefact.h"
#include "model/module/homewatch.h"
#include "model/module/limitwatch.h"
#include "model/module/measuredspeed.h"
#include "model/module/stepperstate.h"
#include "model/module/swingwatch.h"
#include "model/module/tripwatch.h"
#include "model/settings/machine.h"
#include "model/settings/operatorrights.h"
#include "module/registers.h"

namespace nmc {

/// The mode that the last motion command of this connection requested.
enum class MotionMode : std::uint8_t { None, Trapezoidal, Velocity, Pwm, Path };

/// Everything known about one module: a value, updated by the engine's events and displayed by the panels.
/// Values that cannot be queried from the module are beliefs, derived from what was sent and confirmed in
/// this connection.
///
/// The registers of a PIC-SERVO are public members, as confirmed in this connection.
struct ModuleState : ServoRegisters {
    bus::ModuleInfo info;
    /// Latest value of every item; an item never reported is empty.
    std::optional<StatusReport> latest;
    TimePoint latestTime;
    /// Status replies in the last second.
    double repliesPerSecond = 0.0;
    bool silent = false;
    /// Silent only because nothing is sent to it any more (LinkState::quiet).
    bool notAsked = false;
    /// It has not confirmed a stop of all motors, which is repeated until it does.
    bool stopUnconfirmed = false;
    /// The chain is being searched for at its last addresses: this is the last reported state, and only stops
    /// are accepted.
    bool lookedFor = false;
    bool hasRestarted = false;
    /// Part of a read-only connection: it is sent no commands (faults.md H-02).
    bool readOnly = false;
    /// The line is lent to a program, so this panel sends nothing (docs/lending.md).
    bool lent = false;
    /// What an operator may request from it; empty: the panel is not locked.
    std::optional<OperatorRights> rights;
    /// The last operation that this panel requested from it, until that has ended; stops do not count.
    std::optional<bus::OperationId> awaited;
    /// The gains before the present ones, of which those of a trial are neither; empty: unknown.
    std::optional<servo::SetGain> gainsBefore;
    MotionMode motion = MotionMode::None;
    /// Goal velocity of velocity mode, counts/tick, signed; distinguishes "at speed" from "at rest".
    double goalVelocity = 0.0;
    /// PIC-SERVO: when the last command that started or stopped a motion was latched.
    TimePoint motionCommandedAt;
    /// Progress of the last path in which this is the first axis.
    std::optional<bus::PathProgress> path;
    /// The state of what Set Homing Mode last requested.
    HomeWatch homing;
    LimitWatch limits;
    /// The home position, which is not the content of the chip's home register.
    HomeFact home;
    /// The module that the machine has at this place; empty: any.
    std::optional<ModuleIdentity> expected;
    bool nothingSetUp = false;  ///< the machine has nothing at this place that goes by that module's type
    // How the axis may move, as set by the user; the preconditions in model/intent check these.
    UnitKind unit = UnitKind::Native;
    TravelSettings travel;
    BacklashSettings backlash;
    LimitStopSettings limitStop;
    MeasuredSpeed speed;
    /// PIC-SERVO: whether it oscillates where it should hold.
    SwingWatch swing;
    /// The servo went off while it was on, without a command of ours, according to two replies in a row, and
    /// has not been on since.
    bool switchedItselfOff = false;
    /// PIC-SERVO: the cause of switchedItselfOff, as far as it can be determined.
    TripCause tripCause = TripCause::Unknown;
    /// The servo switched itself off, and motor power was missing when this was noticed.
    bool powerLostWhileOn = false;
    /// The last command that affects the servo switched it off.
    bool offCommanded = false;
    /// PIC-STEP: what it was sent, and what it does.
    StepperState stepper;
    /// PIC-I/O: what it was sent, and the rate of its counter.
    IoRegisters pins;
    MeasuredSpeed counting;

    void apply(const bus::Sample& sample);
    void apply(const bus::CommandExecuted& executed);
    /// The module lost all its settings.
    void restarted();
    /// The module was found as another host left it: whether a servo moves is unknown until it is stopped,
    /// moved or off.
    void attached();
    /// A command may have reached the module, but its answer was lost: whether it moves is unknown, whatever
    /// was believed before.
    void doubtMotion();
    /// Gains were sent, but whether the module accepted them is unknown.
    void doubtGains();
    /// The bus has forgotten what was loaded: a start would run nothing.
    void forgetLoad() {
        loadWaiting = false;
        stepper.waiting.reset();
    }
    /// The bus has seen the module at rest, twice, after a stop.
    void confirmedAtRest();

    /// True only for versions known here; modules of other versions are only monitored.
    [[nodiscard]] bool isServo() const { return info.identity.type == ModuleType::Servo && isKnown(); }
    [[nodiscard]] bool isStepper() const { return info.identity.type == ModuleType::Stepper && isKnown(); }
    [[nodiscard]] bool isIo() const { return info.identity.type == ModuleType::Io && isKnown(); }
    [[nodiscard]] bool isKnown() const { return nmc::isKnown(info.identity); }
    /// Not of the expected type or version.
    [[nodiscard]] bool replaced() const {
        return expected && *expected != info.identity && info.identity != kUnheardModule;
    }
    /// Not of the type that the axis is set up for: the settings do not apply to it, and it is only stopped,
    /// until the user has accepted it.
    [[nodiscard]] bool otherType() const { return !nothingSetUp && isOtherType(expected, info.identity); }
    /// As last reported.
    [[nodiscard]] std::optional<std::int32_t> position() const {
        return latest ? latest->position : std::nullopt;
    }
    /// The position for what depends on it: empty while it is doubtful. No stop of a motor in motion may
    /// depend on it.
    [[nodiscard]] std::optional<std::int32_t> certainPosition() const {
        return positionDoubtful() ? std::nullopt : position();
    }
    [[nodiscard]] bool servoOn() const;
    /// PIC-SERVO: after power-up, a limit pin is an input (DS-V 5.2), and on an SC, it always is. In a chain
    /// that was found running, another host may have set it.
    [[nodiscard]] bool limitPinsKnown() const { return isSc(info.identity) || pathControl.has_value(); }
    /// AMP_EN in a stop that is to leave it as it is. If it is unknown, a servo that is on most likely needs
    /// it: without it, the motor coasts. A PIC-STEP that is off according to only one reply is most likely
    /// on.
    [[nodiscard]] bool amplifierKept() const {
        return isStepper() ? stepper.amplifierOn() || stepper.maybeOff() : amplifierEnabled.value_or(true);
    }
    /// PIC-SERVO: the motor's current has been limited since this was last cleared.
    [[nodiscard]] bool currentWasLimited() const;
    /// The exact position that the motor holds or will hold: the goal of its last move or of a Stop Here, or
    /// its position when it was switched on. CMC and SC report it themselves.
    [[nodiscard]] std::optional<std::int32_t> goal() const;
    /// CMC and SC: the position that the servo holds or follows, as last reported; empty while it is off.
    [[nodiscard]] std::optional<std::int32_t> commandPosition() const {
        return servoOn() ? m_commandPosition : std::nullopt;
    }
    /// The direction of the move that leads to goal(); empty: there is none, or it was not a move.
    [[nodiscard]] std::optional<bool> goalReverse() const;
    /// True if the motor moves to `goal`, or holds there, because of the last motion command. A stop ends
    /// that even where it changes nothing, because it may have been meant for more than this motor.
    [[nodiscard]] bool headsFor(std::int32_t goal) const;
    /// PIC-SERVO: what a start would run, if a load is waiting for one.
    [[nodiscard]] std::optional<servo::LoadTrajectory> waiting() const {
        return isServo() && loadWaiting ? std::optional(trajectory()) : std::nullopt;
    }
    /// True if the velocity that the user reads is the one that the chip would be sent. False if the axis is
    /// read in units per second and the length of its ticks is unknown.
    [[nodiscard]] bool speedsKnown() const { return !isServo() || servoRate || unit == UnitKind::Native; }
    /// The position recently jumped where no motion leads: another module of the same type may have answered
    /// in its place, and only the position distinguishes the two.
    [[nodiscard]] bool positionDoubtful() const;
    /// The servo, or the amplifier of a stepper, is on: the motor holds or moves.
    [[nodiscard]] bool driveOn() const;
    /// The drive switched itself off, according to one reply; the next one decides (docs/link.md 2.4).
    [[nodiscard]] bool maybeOff() const {
        return !silent && (isStepper() ? stepper.maybeOff() : m_looksWhileOff == 1);
    }
    /// SC: limit protection is enabled (I/O Control), and the limit in this direction, -1 or 1, is closed;
    /// forward is limit 1.
    [[nodiscard]] bool limitEnds(int direction) const;
    /// The chip has stopped the motor at a limit that it was set to watch, and has not been armed again. If
    /// it was armed without that limit, the motor is still on the switch.
    [[nodiscard]] bool stoppedByLimitStop() const;
    /// PIC-SERVO: it is off, but its shaft moves.
    [[nodiscard]] bool turns() const { return isServo() && !servoOn() && m_drifts; }
    /// CMC and SC: it is running path points.
    [[nodiscard]] bool onPath() const;
    /// A motion that must not be disturbed: a trapezoidal move in progress, or any command velocity other
    /// than 0.
    [[nodiscard]] bool moving() const;
    /// moving(), unless a stop has confirmed it at rest since the report that shows it moving: the looks of a
    /// stop are not always reported, and after LinkState::quiet there are no later reports. Nothing that
    /// depends on where the motor is may go by this.
    [[nodiscard]] bool stillMoves() const { return moving() && !m_restConfirmed; }
    /// It is known whether it moves. Of a servo that was on when it was found, only a second report shows
    /// that.
    [[nodiscard]] bool motionSeen() const {
        return activity() != Activity::Unknown && (!m_motionUnknown || m_looksWhileOn > 1);
    }
    [[nodiscard]] Activity activity() const;

private:
    /// A command has started or stopped a motion; call after whatever depends on the one before.
    void commanded(MotionMode mode, TimePoint time);
    void applyLoaded(TimePoint time);
    void apply(const servo::StopMotor& stop, TimePoint time);
    void watchPath(const StatusReport& report);
    void watchDrift(const bus::Sample& sample, bool wasOn);
    [[nodiscard]] bool watchHome(const bus::Sample& sample);
    /// Direction of a motion that we started, -1 or 1; 0: unknown.
    [[nodiscard]] int direction() const;
    void endedByChip(servo::StopManner manner);
    void endAtLimit();
    void watchLimits(bool wasMoving, const HomeWatch& before, std::optional<Activity> endedBefore);
    [[nodiscard]] LimitWatch::Limits closedLimits() const;
    void maybeWentOff(bool byHome);
    void wentOff();
    [[nodiscard]] TripCause causeOfTrip() const;
    void noteCommand(TimePoint time, int direction, double countsPerTick);
    [[nodiscard]] TripWatch::Reading tripLook() const;
    [[nodiscard]] bool changedPlaceLately() const;
    [[nodiscard]] Activity activityWhileOff() const;
    [[nodiscard]] Activity activityWhileOn() const;

    std::optional<servo::SetGain> m_gainsSet;  ///< the last that were not sent by a trial
    std::optional<std::int32_t> m_goal;        ///< see goal()
    std::optional<bool> m_goalReverse;         ///< see goalReverse()
    std::optional<std::int32_t> m_commandPosition;
    /// The position that a stop will make it hold, if the next status shows it within `within` counts of
    /// `stood`.
    struct Held {
        std::int32_t goal = 0;
        std::int32_t stood = 0;
        std::int32_t within = 0;
    };
    [[nodiscard]] std::optional<Held> heldThroughStop() const;
    std::optional<Held> m_held;
    unsigned m_looksWhileOn = 0;   ///< in a row
    unsigned m_looksWhileOff = 0;  ///< in a row, that show it went off by itself, until that is certain
    unsigned m_looksToBeOff = 0;   ///< how many make it certain
    TripCause m_causeSeen = TripCause::Unknown;  ///< according to the first of them
    std::optional<TimePoint> m_jumpedAt;         ///< the last time
    std::optional<TimePoint> m_changedPlaceAt;   ///< the last time, while watchDrift() is active
    bool m_motionUnknown = false;
    bool m_restConfirmed = false;  ///< and since then, it has neither reported nor executed anything
    bool m_drifts = false;         ///< its position has changed recently; slow velocities read 0
    std::optional<bus::Sample> m_restedAt;
    TripWatch m_trip;
};

/// Returns null if the chain has no such module.
[[nodiscard]] inline const ModuleState* moduleAt(ModuleIndex index, std::span<const ModuleState> modules) {
    return index.value() < modules.size() ? &modules[index.value()] : nullptr;
}

}  // namespace nmc
