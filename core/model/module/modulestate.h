// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

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

/// What the last motion command of this connection asked for.
enum class MotionMode : std::uint8_t { None, Trapezoidal, Velocity, Pwm, Path };

/// Everything known of one module: a value, fed by the engine's events, shown by the panels.
/// Values that the module cannot be asked for are beliefs, from what was sent and confirmed in this
/// connection.
///
/// The registers of a PIC-SERVO are public members of it, as confirmed in this connection.
struct ModuleState : ServoRegisters {
    bus::ModuleInfo info;
    /// Latest value of every item; an item never reported is empty.
    std::optional<StatusReport> latest;
    TimePoint latestTime;
    /// Status replies per second, as of the last second.
    double repliesPerSecond = 0.0;
    bool silent = false;
    /// The chain is looked for where it was: this is what the module said last, and it takes stops only.
    bool lookedFor = false;
    bool hasRestarted = false;
    /// Of a read-only connection: it is told nothing (faults.md H-02).
    bool readOnly = false;
    /// What an operator may ask of it; empty: the panel is not locked.
    std::optional<OperatorRights> rights;
    /// What it was asked for last by this panel, as long as that has not ended; stops apart.
    std::optional<bus::OperationId> awaited;
    /// Gains from before those; empty: unknown.
    std::optional<servo::SetGain> gainsBefore;
    MotionMode motion = MotionMode::None;
    /// Goal velocity of velocity mode, counts/tick, signed; for telling "at speed" from "at rest".
    double goalVelocity = 0.0;
    /// PIC-SERVO: when the last command was latched that started or stopped a motion.
    TimePoint motionCommandedAt;
    /// How far the last path is of which this is the first axis.
    std::optional<bus::PathProgress> path;
    /// What Set Homing Mode last told it.
    HomeWatch homing;
    LimitWatch limits;
    /// Where home is, which is not what the chip's register says.
    HomeFact home;
    // How it may move, as the user has set it: the rules of model/intent ask these.
    UnitKind unit = UnitKind::Native;
    TravelSettings travel;
    BacklashSettings backlash;
    LimitStopSettings limitStop;
    MeasuredSpeed speed;
    /// PIC-SERVO: whether it swings where it is to hold.
    SwingWatch swing;
    /// The servo went off without a command of ours while it was on, as two answers in a row say, and has not
    /// been on since.
    bool switchedItselfOff = false;
    /// Of switchedItselfOff, on a PIC-SERVO: why, as far as that can be told.
    TripCause tripCause = TripCause::Unknown;
    /// As above, and motor power was missing when it was noticed.
    bool powerLostWhileOn = false;
    /// The last command that concerns the servo switched it off.
    bool offCommanded = false;
    /// PIC-STEP: what it was told, and does.
    StepperState stepper;
    /// PIC-I/O: what it was told, and how fast its counter counts.
    IoRegisters pins;
    MeasuredSpeed counting;

    void apply(const bus::Sample& sample);
    void apply(const bus::CommandExecuted& executed);
    /// It lost everything it was told.
    void restarted();
    /// It was found as another host left it: what moves it is not known until it is stopped, moved or off.
    void attached();
    /// It may have been told what nobody has heard an answer to: as above, whatever was believed before.
    void doubtMotion();
    /// It was sent gains, and nobody has heard whether it took them.
    void doubtGains();
    /// The bus has seen it at rest, twice, after a stop.
    void confirmedAtRest();

    /// Of a version that is known here; others are only looked at.
    [[nodiscard]] bool isServo() const { return info.identity.type == ModuleType::Servo && isKnown(); }
    [[nodiscard]] bool isStepper() const { return info.identity.type == ModuleType::Stepper && isKnown(); }
    [[nodiscard]] bool isIo() const { return info.identity.type == ModuleType::Io && isKnown(); }
    [[nodiscard]] bool isKnown() const { return nmc::isKnown(info.identity); }
    [[nodiscard]] bool servoOn() const;
    /// PIC-SERVO: it has limited the motor's current since that was cleared last.
    [[nodiscard]] bool currentWasLimited() const;
    /// The position that the motor holds or will, to the count: the goal of its last move or of a Stop Here,
    /// or where it stood when it was switched on.
    /// CMC and SC tell it themselves.
    [[nodiscard]] std::optional<std::int32_t> goal() const;
    /// CMC and SC: what the servo holds or follows, as it told last; nothing while it is off.
    [[nodiscard]] std::optional<std::int32_t> commandPosition() const {
        return servoOn() ? m_commandPosition : std::nullopt;
    }
    /// The direction of the move that leads to goal(); nothing: there is none, or it was no move.
    [[nodiscard]] std::optional<bool> goalReverse() const;
    /// What moves it, or holds it, is still the move to there that was commanded last. A stop ends that even
    /// where it changes nothing, since it may have been meant for more than this motor.
    [[nodiscard]] bool headsFor(std::int32_t goal) const;
    /// PIC-SERVO: what a start would run, if a load waits for one.
    [[nodiscard]] std::optional<servo::LoadTrajectory> waiting() const {
        return isServo() && loadWaiting ? std::optional(trajectory()) : std::nullopt;
    }
    /// What the user reads as a velocity is what the chip would be sent: not where the axis is read in units
    /// per second and nobody knows how long its ticks are.
    [[nodiscard]] bool speedsKnown() const { return !isServo() || servoRate || unit == UnitKind::Native; }
    /// Its position jumped lately where no motion leads to: another module of its type may have answered for
    /// it, and nothing but its positions tells the two apart.
    [[nodiscard]] bool positionDoubtful() const;
    /// The servo is on, or the amplifier of a stepper: the motor holds or moves.
    [[nodiscard]] bool driveOn() const;
    /// SC: it minds its limits (I/O Control), and that in this direction, -1 or 1, is closed; forward is
    /// limit 1.
    [[nodiscard]] bool limitEnds(int direction) const;
    /// CMC and SC: it runs through path points.
    [[nodiscard]] bool onPath() const;
    /// A motion that must not be disturbed: a trapezoidal move under way, or any command velocity but 0.
    [[nodiscard]] bool moving() const;
    [[nodiscard]] Activity activity() const;

private:
    void applyLoaded(TimePoint time);
    void apply(const servo::StopMotor& stop, TimePoint time);
    void startPath(TimePoint time);
    void watchPath(const StatusReport& report);
    void watchDrift(const bus::Sample& sample, bool wasOn);
    [[nodiscard]] bool watchHome(const bus::Sample& sample);
    /// -1 or 1: where a motion of ours goes; 0: nobody knows.
    [[nodiscard]] int direction() const;
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

    std::optional<std::int32_t> m_goal;  ///< as goal() says
    std::optional<bool> m_goalReverse;   ///< likewise
    std::optional<std::int32_t> m_commandPosition;
    /// What it will hold by a stop, if the next status shows it within that many counts of where it stood.
    struct Held {
        std::int32_t goal = 0;
        std::int32_t stood = 0;
        std::int32_t within = 0;
    };
    [[nodiscard]] std::optional<Held> heldThroughStop() const;
    std::optional<Held> m_held;
    unsigned m_looksWhileOn = 0;   ///< in a row
    unsigned m_looksWhileOff = 0;  ///< in a row, that say that it went off by itself, until that is a fact
    unsigned m_looksToBeOff = 0;   ///< how many make it one
    TripCause m_causeSeen = TripCause::Unknown;  ///< by the first of them
    std::optional<TimePoint> m_jumpedAt;         ///< last
    std::optional<TimePoint> m_changedPlaceAt;   ///< last, while watchDrift() looks
    bool m_motionUnknown = false;
    bool m_drifts = false;  ///< its position has changed lately; slow velocities read 0
    std::optional<bus::Sample> m_restedAt;
    TripWatch m_trip;
};

/// Null: the chain has no such module.
[[nodiscard]] inline const ModuleState* moduleAt(ModuleIndex index, std::span<const ModuleState> modules) {
    return index.value() < modules.size() ? &modules[index.value()] : nullptr;
}

}  // namespace nmc
