// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "base/time.h"
#include "bus/types.h"
#include "protocol/commands.h"

namespace nmc {

/// The command position of one PIC-SERVO v1-v4, rebuilt from what was sent, because the chip reports neither it nor
/// the position error (scope.md). Closed-form profile mathematics in continuous time, independent of the simulator.
/// Positions in counts, times from the bus clock. Nothing where it cannot be known.
class CommandPosition {
public:
    /// Follows a command that the module has carried out.
    void apply(const bus::CommandExecuted& executed);
    /// Follows a status: learns of a servo that is off, and of where it held when it was switched on.
    void apply(const bus::Sample& sample);
    /// After a doubt (silence, restart): unknown until the next command that fixes it.
    void forget();

    /// The command position at `time`; empty while unknown or the servo is off.
    [[nodiscard]] std::optional<double> at(TimePoint time) const;
    /// The calculated profile has ended: the command rests.
    [[nodiscard]] bool atRest(TimePoint time) const;

private:
    /// A constant-acceleration piece sequence: accelerate, slew, decelerate. Velocity in counts/s.
    struct Motion {
        TimePoint start;
        double p0 = 0, v0 = 0;
        double accelTime = 0, slewTime = 0, decelTime = 0;  ///< s
        double accel = 0, decel = 0;                        ///< counts/s^2, signed
        double end = 0;                                     ///< goal of a trapezoidal move
        bool endsAtGoal = false;                            ///< else the last velocity goes on for ever
        [[nodiscard]] double position(double s) const;
        [[nodiscard]] double velocity(double s) const;
        [[nodiscard]] double duration() const { return accelTime + slewTime + decelTime; }
    };

    void hold(TimePoint time, double position);
    void startMotion(TimePoint time);
    void startVelocity(TimePoint time, double goal);
    void startTrapezoid(TimePoint time);
    void stop(const servo::StopMotor& stop, TimePoint time);

    std::optional<Motion> m_motion;             ///< empty: unknown or servo off
    servo::LoadTrajectory m_loaded;             ///< control bits of the last load
    std::optional<double> m_goal;               ///< counts
    double m_velocity = 0;                      ///< counts/s, as loaded, >= 0
    double m_acceleration = 0;                  ///< counts/s^2
    double m_tick = toSeconds(kServoTick);      ///< servo tick, s; SR times 0.512 ms
    std::optional<double> m_lastPosition;       ///< last measured
    TimePoint m_changed;                        ///< statuses from before this do not tell about the present state
};

}  // namespace nmc
