// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/types.h"
#include "model/profilecurve.h"
#include "protocol/commands.h"

namespace nmc {

/// The command position of one PIC-SERVO v1-v4, rebuilt from what was sent, because the chip reports neither
/// it nor the position error (scope.md). Independent of the simulator. Nothing where it cannot be known.
///
/// Fed in the order of the bus: of one exchange first the command, then the sample.
class CommandPosition {
public:
    /// Follows a command that the module has carried out.
    void apply(const bus::CommandExecuted& executed);
    /// Follows a status: learns of a servo that went off, and where it holds after it was switched on.
    void apply(const bus::Sample& sample);
    /// After a doubt (silence, restart): unknown until a command fixes it again.
    void forget();

    /// The command position at `time`; empty while unknown or the servo is off.
    [[nodiscard]] std::optional<double> at(TimePoint time) const;

private:
    /// What makes the command position known again.
    enum class Awaiting : std::uint8_t {
        Nothing,
        HeldPosition,  ///< the servo was just switched on: it holds where the next sample says it is
        EndOfMove,     ///< a trapezoidal move from an unknown place: when it is done, it is at its goal
    };

    void load(const servo::LoadTrajectory& load);
    void start(TimePoint time);
    /// Towards a goal velocity in counts/tick, signed, from what it is.
    void changeVelocity(TimePoint time, double goal);
    /// When the continuous curve begins for which the chip's staircase is the best match. The chip takes its
    /// first step 1..SR maximum-rate ticks after the command, a whole step high; on average that is this.
    [[nodiscard]] TimePoint effective(TimePoint time) const;
    void stop(const servo::StopMotor& stop, TimePoint time);
    void zero(TimePoint time);
    void setTick(double seconds, TimePoint time);
    void begin(TimePoint time, ProfileCurve curve);
    [[nodiscard]] double secondsAt(TimePoint time) const { return toSeconds(time - m_started); }
    [[nodiscard]] double perSecond(double countsPerTick) const { return countsPerTick / m_tick; }

    std::optional<ProfileCurve> m_curve;  ///< empty: unknown, or the servo is off
    TimePoint m_started;
    Awaiting m_awaiting = Awaiting::Nothing;
    bool m_servoOn = false;                 ///< as commanded or reported, whichever is newer
    bool m_homingStops = false;             ///< armed to stop by itself at a moment we shall not know
    servo::LoadTrajectory m_loaded;         ///< control bits of the last load
    double m_goal = 0;                      ///< counts; survives a load without a position
    double m_velocity = 0;                  ///< counts/tick, >= 0
    double m_acceleration = 0;              ///< counts/tick^2
    double m_tick = toSeconds(kServoTick);  ///< SR x 0.512 ms
};

}  // namespace nmc
