// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// The trajectory generator (DS-V 4.4): where the motor should be at each servo tick.
///
/// Units are 1/65536 count and 1/65536 count per servo tick throughout; positions are 48 bits wide (32.16)
/// and wrap. Per tick the velocity changes by at most the acceleration, then the position by the velocity. A
/// trapezoidal move ends exactly on its goal (protocol.md 2, a choice: no source gives the rounding).
class Profile {
public:
    enum class Mode : std::uint8_t { Hold, Trapezoidal, Velocity, Path };

    /// The servo is off: the command follows the motor.
    void follow(std::int32_t position, std::int32_t countsPerTick);
    /// Stands at `position` at once.
    void hold(std::int32_t position);
    /// Reset Position: the command is now called `position`; the rest stays as it is.
    void rename(std::int32_t position);
    /// The command moves by whole counts at once: a step pulse, or another origin.
    void shift(std::int32_t counts);
    /// Begins at velocity zero whatever the velocity was, or goes on from the present one. `velocity` and
    /// `acceleration` are 0..7FFFFFFF.
    enum class Start : std::uint8_t { AtZero, AtPresentVelocity };
    void startTrapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration,
                        Start start = Start::AtZero);
    /// Goes on from the present velocity. `goalVelocity` is signed, its magnitude 0..7FFFFFFF.
    void startVelocity(std::int64_t goalVelocity, std::uint32_t acceleration);
    /// Velocity and goal velocity 0 where it is, in velocity mode.
    void stopAbruptly();
    /// Goal velocity 0 at the current acceleration, in velocity mode.
    void stopSmoothly();

    /// Instead of step(): one servo tick of a path, at this velocity.
    void stepPath(std::int64_t velocity);
    /// The end of a path: stands where it is.
    void endPath();

    /// One servo tick.
    void step();

    [[nodiscard]] Mode mode() const { return m_mode; }
    /// Whole counts, rounded down.
    [[nodiscard]] std::int32_t position() const { return static_cast<std::int32_t>(m_position >> 16); }
    /// With its 16 bits of fraction.
    [[nodiscard]] std::int64_t finePosition() const { return m_position; }
    [[nodiscard]] std::int64_t velocity() const { return m_velocity; }
    /// The move is complete, or in velocity mode the goal velocity reached.
    [[nodiscard]] bool done() const { return m_done; }
    [[nodiscard]] bool accelerationDone() const { return m_accelerationDone; }
    [[nodiscard]] bool slewDone() const { return m_slewDone; }
    /// In the last servo tick the speed grew, or did not change.
    [[nodiscard]] bool accelerating() const { return m_accelerating; }
    [[nodiscard]] bool slewing() const { return m_slewing; }
    /// 1 forward, -1 reverse: where it moves or is about to move; 0 where it stands.
    [[nodiscard]] int direction() const;

    /// Power-up state.
    void reset() { *this = Profile{}; }

private:
    void stepperMode();
    void stepTrapezoid();
    void stepVelocity();
    /// Velocity of the next tick towards a goal at `distance` > 0, before the bounds of the acceleration.
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
    bool m_slewing = false;  ///< after power-up until the first tick
};

/// The largest velocity from which reducing it by `acceleration` > 0 per tick covers `distance` >= 0, rounded
/// down. Exact for distances below 2^48 and accelerations below 2^31; units as in Profile.
[[nodiscard]] std::int64_t stoppingVelocity(std::int64_t distance, std::int64_t acceleration);

}  // namespace nmc::sim
