// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/types.h"
#include "model/scope/commandenvelope.h"
#include "model/scope/standingerror.h"
#include "module/registers.h"

namespace nmc {

/// The command position of one PIC-SERVO v1-v4, rebuilt from what was sent, because the chip reports neither
/// it nor the position error (scope.md). Independent of the simulator. Nothing where it cannot be known;
/// elsewhere with bounds, and the true one is within them.
///
/// Time: the chip carries a command out, and latches a status, at the end of a maximum-rate tick t (DS-V
/// 4.1), which is T - t/2 .. T + t/2 for the T that the bus reports, or later by as much as kPromptWithin and
/// `late`; where its reply came before the end of that, the end is earlier (a negative `late`). Its profile
/// makes a step every servo tick S = SR x t, of unknown phase. With n steps before a command, the curve that
/// matches the steps begins at n x S, which is the command's moment or up to S - t before it; with N steps
/// before a status, the curve is where the steps are at (N + 1/2) x S (DS-V 4.4). So a change begins T + t/2
/// - S .. T + t/2, and a status shows T + t/2 - S/2 .. T + t/2 + S/2. Where it is known which tick it was
/// (TickClock), t is no part of that, and all moments are by the module's clock.
///
/// Fed in the order of the bus: of one exchange first the command, then the sample.
class CommandPosition {
public:
    /// Follows a command that the module has carried out.
    void apply(const bus::CommandExecuted& executed);
    /// Follows a status: learns of a servo that went off, where it holds after it was switched on, how far a
    /// motion has come, and of a stop at home.
    void apply(const bus::Sample& sample);
    /// After a doubt (silence, restart): unknown until a command fixes it again.
    void forget();
    /// It cannot be where it was calculated: unknown until the move ends, or a command fixes it again.
    void contradicted();
    /// How long a tick is is not known until gains are set: a motion cannot be followed, a rest can.
    void doubtServoRate();
    /// Nobody will find out any more what became of a command whose answer was lost, if there is one.
    void cancelled();

    /// The command position when a status was latched, `time` and `late` as in bus::Sample; empty while
    /// unknown or the servo is off.
    [[nodiscard]] std::optional<CommandEstimate> at(TimePoint time, Duration late = {}) const;
    /// EL as set in this connection: the servo switches itself off beyond it. Counts.
    [[nodiscard]] std::optional<int> errorLimit() const {
        return m_registers.gains ? std::optional<int>(m_registers.gains->el) : std::nullopt;
    }

private:
    /// What makes the command position known again.
    enum class Awaiting : std::uint8_t {
        Nothing,
        HeldPosition,  ///< the servo was just switched on: it holds where the next sample says it is
        EndOfMove,     ///< a trapezoidal move from an unknown place: when it is done, it is at its goal
    };
    enum class Motion : std::uint8_t { None, Trapezoid, Velocity };
    /// Armed to stop by itself.
    struct HomingStop {
        servo::StopManner manner;
        TimePoint shows;    ///< a status from then on tells whether home has been found
        Moments searching;  ///< when home had not been found yet
    };

    void start(const bus::CommandExecuted& executed);
    void startAs(const bus::CommandExecuted& executed);
    void stop(const servo::StopMotor& stop, const bus::CommandExecuted& executed);
    void zero(const bus::CommandExecuted& executed);
    void arm(const servo::SetHoming& homing, const bus::CommandExecuted& executed);
    void setServoRate(std::uint8_t divisor, const bus::CommandExecuted& executed);
    void stopAtHome(const Moments& found, TimePoint shows);
    void learnHome(const bus::Sample& sample, servo::StatusByte status);
    void learnHeldPosition(const bus::Sample& sample);
    void learnProgress(const bus::Sample& sample, servo::StatusByte status, servo::AuxByte aux);
    void learnContradiction(const bus::Sample& sample, servo::StatusByte status);
    void learnStanding(const bus::Sample& sample, servo::StatusByte status);
    void explain(const bus::CommandExecuted& executed);

    void switchedOff();
    void rest(const CommandEstimate& held);
    void freeze(const Moments& when);
    void runAt(double velocity, const Moments& when);
    /// Of everything that the module says it has latched; `early` as in bus::CommandExecuted.
    void countTicks(TimePoint time, Duration late, Duration early = {});
    /// The tick in which something was latched.
    [[nodiscard]] Moments latched(TimePoint time, Duration late, Duration early) const;
    /// When a status was latched, as the curve that matches the steps; `early` as in bus::CommandExecuted.
    [[nodiscard]] Moments shown(TimePoint time, Duration late, Duration early = {}) const;
    [[nodiscard]] Moments shown(const bus::CommandExecuted& executed) const {
        return shown(executed.time, executed.late, executed.early);
    }
    /// When that curve changes by a command.
    [[nodiscard]] Moments begun(const bus::CommandExecuted& executed) const;
    [[nodiscard]] double tick() const { return toSeconds(m_tick); }

    std::optional<CommandEnvelope> m_envelope;  ///< empty: unknown, or the servo is off
    Motion m_motion = Motion::None;
    Awaiting m_awaiting = Awaiting::Nothing;
    std::optional<HomingStop> m_homing;
    /// Since then it says that it moves, and nothing that is known of has set it going: the answer to a start
    /// was lost perhaps, and what it did is told later.
    std::optional<TimePoint> m_strange;
    /// What the last status shows may come of a command of which is not known whether it was carried out.
    bool m_unsettled = false;
    bool m_verified = false;            ///< that the last command was carried out is what looks have told
    std::optional<bus::Sample> m_look;  ///< the last one of these
    StandingError m_standing;
    TickClock m_ticks;
    bool m_lostCount = false;  ///< of its ticks, in this motion
    ServoRegisters m_registers;
    bool m_servoOn = false;                ///< as commanded or reported, whichever is newer
    TimePoint m_commanded;                 ///< when the last command that changes the motion was carried out
    bool m_repeated = false;               ///< that one, perhaps: it may have been carried out before
    TimePoint m_effective;                 ///< a status from then on shows what came of it
    double m_runningGoal = 0;              ///< of the last start
    double m_runningAcceleration = 0;      ///< of the last start
    double m_runningVelocity = 0;          ///< counts/tick, signed; of Motion::Velocity
    std::optional<double> m_lastPosition;  ///< as reported last
    TimePoint m_lastTime;                  ///< and when
    Duration m_tick = kServoTick;          ///< SR x 0.512 ms; unknown: as long as it can be
    bool m_tickKnown = true;
};

}  // namespace nmc
