// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace nmc {

/// A profile as the chip would run it, in continuous time: accelerate, slew, decelerate (DS-V 4.4).
/// Positions in counts, time in seconds from the start, velocities in counts/s.
class ProfileCurve {
public:
    enum class Phase : std::uint8_t { Acceleration, Slew, Last };
    struct Range {
        double low = 0;
        double high = 0;
    };

    /// A curve that rests at a position.
    static ProfileCurve rest(double position);
    /// A move from standstill at `from` exactly to `goal`; triangular when the distance is too short for the
    /// velocity.
    static ProfileCurve trapezoid(double from, double goal, double velocity, double acceleration);
    /// Changes from `velocity` to `goalVelocity` at `acceleration`, then continues forever.
    static ProfileCurve velocityChange(double from, double velocity, double goalVelocity,
                                       double acceleration);

    /// Before its start, the curve has its start velocity.
    [[nodiscard]] double position(double s) const;
    [[nodiscard]] double velocity(double s) const;
    /// The range of positions between two times.
    [[nodiscard]] Range range(double from, double to) const;
    /// The time at which a phase ends; infinite when it never ends. After the last phase the velocity is
    /// constant.
    [[nodiscard]] double endOf(Phase phase) const;
    [[nodiscard]] double duration() const { return endOf(Phase::Last); }
    [[nodiscard]] double goalVelocity() const { return m_endVelocity; }
    /// The same curve with time slowed down by `factor`, for a changed servo rate divisor.
    [[nodiscard]] ProfileCurve stretched(double factor) const;
    /// The same curve moved by `counts`; the goal of a trapezoid does not move.
    [[nodiscard]] ProfileCurve shifted(double counts) const;

private:
    double m_from = 0, m_startVelocity = 0;
    double m_accelTime = 0, m_slewTime = 0, m_decelTime = 0;
    double m_accel = 0, m_decel = 0;  ///< signed, counts/s^2
    double m_endVelocity = 0;
    std::optional<double> m_goal;  ///< the exact end position
};

}  // namespace nmc
