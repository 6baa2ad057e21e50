// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// The trajectory generator (DS-V 4.4): it computes the command position for each servo tick.
///
/// Units are 1/65536 count and 1/65536 count per servo tick throughout; positions are 48 bits wide (32.16)
/// and wrap. In each tick the velocity changes by at most the acceleration, then the position by the
/// velocity. A trapezoidal move ends exactly on its goal (protocol.md 2, a choice: no source specifies the
/// rounding).
class Profile {
public:
    enum class Mode : std::uint8_t { Hold, Trapezoidal, Velocity, Path };

    /// Servo off: the command position follows the motor.
    void follow(std::int32_t position, std::int32_t countsPerTick);
    /// Holds the command position at `position`, effective immediately.
    void hold(std::int32_t position);
    /// Reset Position: the command position becomes `position`; everything else stays unchanged.
    void rename(std::int32_t position);
    /// Moves the command position by whole counts at once, for a step pulse or a new origin.
    void shift(std::int32_t counts);
    /// A trapezoidal move starts at velocity zero, whatever the velocity was, or continues from the present
    /// velocity. `velocity` and `acceleration` are 0..7FFFFFFF.
    enum class Start : std::uint8_t { AtZero, AtPresentVelocity };
    void startTrapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration,
                        Start start = Start::AtZero);
    /// Continues from the present velocity. `goalVelocity` is signed; its magnitude is 0..7FFFFFFF.
    void startVelocity(std::int64_t goalVelocity, std::uint32_t acceleration);
    /// Sets velocity and goal velocity to 0 at the present position, in velocity mode.
    void stopAbruptly();
    /// Sets the goal velocity to 0 with the current acceleration, in velocity mode.
    void stopSmoothly();
    /// The current acceleration; both starts set their own.
    void setAcceleration(std::uint32_t acceleration) { m_acceleration = acceleration; }

    /// Executes one servo tick of a path at this velocity; replaces step().
    void stepPath(std::int64_t velocity);
    /// Ends a path; the command position stays where it is.
    void endPath();

    /// Executes one servo tick.
    void step();

    [[nodiscard]] Mode mode() const { return m_mode; }
    /// Command position in whole counts, rounded down.
    [[nodiscard]] std::int32_t position() const { return static_cast<std::int32_t>(m_position >> 16); }
    /// Command position with 16 fractional bits.
    [[nodiscard]] std::int64_t finePosition() const { return m_position; }
    [[nodiscard]] std::int64_t velocity() const { return m_velocity; }
    /// True when the move is complete or, in velocity mode, the goal velocity has been reached.
    [[nodiscard]] bool done() const { return m_done; }
    [[nodiscard]] bool accelerationDone() const { return m_accelerationDone; }
    [[nodiscard]] bool slewDone() const { return m_slewDone; }
    /// True when the speed increased, or stayed the same, in the last servo tick.
    [[nodiscard]] bool accelerating() const { return m_accelerating; }
    [[nodiscard]] bool slewing() const { return m_slewing; }
    /// 1 forward, -1 reverse: the direction in which it moves or is about to move; 0 at rest.
    [[nodiscard]] int direction() const;

private:
    void stepTrapezoid();
    void stepVelocity();
    /// The velocity of the next tick towards a goal at `distance` > 0, before it is limited by the
    /// acceleration.
    [[nodiscard]] std::int64_t approach(std::int64_t distance, std::int64_t wanted) const;

    std::int64_t m_position = 0;
    std::int64_t m_velocity = 0;
    std::int64_t m_goalPosition = 0;
    std::int64_t m_goalVelocity = 0;  ///< magnitude of the slew velocity in a trapezoidal move
    std::int64_t m_acceleration = 0;
    double m_halfInverseAcceleration = 0;
    Mode m_mode = Mode::Hold;
    bool m_done = true;
    bool m_accelerationDone = false;
    bool m_slewDone = false;
    bool m_accelerating = false;
    bool m_slewing = false;  ///< also false after power-up until the first tick
};

/// The largest velocity, rounded down, from which a reduction by `acceleration` > 0 per tick covers
/// `distance` >= 0. Exact for distances below 2^48 and accelerations below 2^31; units as in Profile.
[[nodiscard]] std::int64_t stoppingVelocity(std::int64_t distance, std::int64_t acceleration);

}  // namespace nmc::sim
