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

/// The command position of one PIC-SERVO v1-v4, reconstructed from the commands sent, because the chip
/// reports neither it nor the position error (scope.md). Independent of the simulator. The result is empty
/// where the command position cannot be known, and otherwise has bounds that contain the true value.
///
/// Time: the chip executes a command, and latches a status, at the end of a maximum-rate tick t (DS-V 4.1).
/// That is T - t/2 .. T + t/2 for the time T that the bus reports, or later by as much as kPromptWithin and
/// `late`; if its reply came before the end of that interval, the interval ends earlier (a negative `late`).
/// Its profile advances by a step every servo tick S = SR x t, of unknown phase. With n steps before a
/// command, the curve that matches the steps begins at n x S, which is the command's moment or up to S - t
/// before it; with N steps before a status, the curve is where the steps are at (N + 1/2) x S (DS-V 4.4). A
/// change therefore begins at T + t/2 - S .. T + t/2, and a status shows T + t/2 - S/2 .. T + t/2 + S/2.
/// Where the tick itself is known (TickClock), t does not contribute, and all moments are by the module's
/// clock.
///
/// Events must be fed in bus order: within one exchange, first the command, then the sample.
class CommandPosition {
public:
    /// Follows a command that the module has executed.
    void apply(const bus::CommandExecuted& executed);
    /// Follows a status: detects that the servo went off, where it holds after it was switched on, how far a
    /// motion has progressed, and a stop at home.
    void apply(const bus::Sample& sample);
    /// Called when the state is in doubt (silence, restart): the position is unknown until a command fixes it
    /// again.
    void forget();
    /// The calculated position is impossible: it is unknown until the move ends, or a command fixes it again.
    void contradicted();
    /// The length of a tick is unknown until gains are set: a motion cannot be followed, but rest can.
    void doubtServoRate();
    /// Another host may have set SR, and loaded a velocity and an acceleration, which stay until others are
    /// loaded (DS-V 5.2).
    void attached();
    /// If the answer to a command was lost, its outcome will never be known.
    void cancelled();

    /// The command position when a status was latched, with `time` and `late` as in bus::Sample; empty while
    /// it is unknown or the servo is off.
    [[nodiscard]] std::optional<CommandEstimate> at(TimePoint time, Duration late = {}) const;
    /// EL as set in this connection, in counts: beyond it the servo switches itself off.
    [[nodiscard]] std::optional<int> errorLimit() const {
        return m_registers.gains ? std::optional<int>(m_registers.gains->el) : std::nullopt;
    }

private:
    /// The event that makes the command position known again.
    enum class Awaiting : std::uint8_t {
        Nothing,
        HeldPosition,   ///< the servo was just switched on: it holds at the position in the next sample
        HeldIfItStood,  ///< likewise, by a smooth stop, which a motor that was moving does not hold at once
        EndOfMove,      ///< a trapezoidal move from an unknown position: when it is done, it is at its goal
    };
    enum class Motion : std::uint8_t { None, Trapezoid, Velocity };
    /// A search for home that stops the motor when home is found.
    struct HomingStop {
        servo::StopManner manner;
        TimePoint shows;    ///< from then on, a status shows whether home has been found
        Moments searching;  ///< the last time at which home had not been found
    };

    [[nodiscard]] static ServoRegisters afterPowerUp();
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
    /// The command starts or stops a motion.
    void commanded(const bus::CommandExecuted& executed);

    void switchedOff();
    void rest(const CommandEstimate& held);
    void freeze(const Moments& when);
    void runAt(double velocity, const Moments& when);
    /// Counts ticks from everything that the module has latched; `early` is as in bus::CommandExecuted.
    void countTicks(TimePoint time, Duration late, Duration early = {});
    /// The tick in which something was latched.
    [[nodiscard]] Moments latched(TimePoint time, Duration late, Duration early) const;
    /// The time of a status on the curve that matches the steps; `early` is as in bus::CommandExecuted.
    [[nodiscard]] Moments shown(TimePoint time, Duration late, Duration early = {}) const;
    [[nodiscard]] Moments shown(const bus::CommandExecuted& executed) const {
        return shown(executed.time, executed.late, executed.early);
    }
    /// The time at which a command changes that curve.
    [[nodiscard]] Moments begun(const bus::CommandExecuted& executed) const;
    [[nodiscard]] double tick() const { return toSeconds(m_tick); }

    std::optional<CommandEnvelope> m_envelope;  ///< empty: unknown, or the servo is off
    Motion m_motion = Motion::None;
    Awaiting m_awaiting = Awaiting::Nothing;
    std::optional<HomingStop> m_homing;
    /// The time since which the module has reported a motion that no known command started: perhaps the
    /// answer to a start was lost, and its outcome will be reported later.
    std::optional<TimePoint> m_strange;
    /// The last status may be the effect of a command whose outcome is unknown.
    bool m_unsettled = false;
    bool m_verified = false;  ///< the last command was found executed by reading the status, not by its
                              ///< answer
    std::optional<bus::Sample> m_look;  ///< the last sample read for that purpose
    StandingError m_standing;
    TickClock m_ticks;
    bool m_lostCount = false;  ///< the tick count was lost during this motion
    ServoRegisters m_registers = afterPowerUp();
    bool m_servoOn = false;                ///< as commanded or reported, whichever is newer
    TimePoint m_commanded;                 ///< time of the last command that changes the motion
    bool m_repeated = false;               ///< that command may have been repeated, and executed earlier
    TimePoint m_effective;                 ///< from then on, a status shows its effect
    double m_runningGoal = 0;              ///< goal of the last start
    double m_runningAcceleration = 0;      ///< acceleration of the last start
    double m_runningVelocity = 0;          ///< counts/tick, signed; velocity in Motion::Velocity
    std::optional<double> m_lastPosition;  ///< last reported position
    TimePoint m_lastTime;                  ///< time of the last reported position
    Duration m_tick = kServoTick;          ///< SR x 0.512 ms; if unknown, the longest possible
    bool m_tickKnown = true;
};

}  // namespace nmc
