// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/time.h"
#include "sim/snapshot.h"
#include "sim/steppertimer.h"
#include "sim/steppertransition.h"

namespace nmc::sim {

/// The step generator: the STEP and DIR outputs and the position counter (DS-S 4.1 to 4.3). It knows nothing
/// of commands, switches and the amplifier.
///
/// It runs in one go between a change of speed, the beginning of a deceleration and the end of a move.
class StepperMotion {
public:
    /// Takes effect at the next start from standstill.
    void setSpeedMode(SpeedMode mode) { m_speedMode = mode; }
    void setMinimumSpeed(std::uint8_t speed) { m_minimum = speed; }

    /// Enters mode `goal` with the loaded parameters. The transition must be allowed.
    void start(StepperMode goal, const StepperTrajectory& loaded);
    /// The direction that start() would take.
    [[nodiscard]] bool wouldReverse(StepperMode goal, const StepperTrajectory& loaded) const;
    void stopAbruptly();
    /// Ramps to the minimum speed with the acceleration time of the last start, then stops.
    void stopSmoothly();

    void resetPosition();
    /// Makes steps for this time; returns the rest of the time when the motion ends earlier.
    Duration advance(Duration time);

    [[nodiscard]] bool isMoving() const { return m_mode != StepperMode::Stopped; }
    [[nodiscard]] StepperMode mode() const { return m_mode; }
    [[nodiscard]] bool isReverse() const { return m_reverse; }
    [[nodiscard]] std::int32_t position() const { return static_cast<std::int32_t>(m_position); }
    /// All steps since power-up, forward steps minus reverse steps; Reset Position does not change it.
    [[nodiscard]] std::int64_t stepsMade() const { return m_stepsMade; }
    [[nodiscard]] bool atCommandedSpeed() const;
    /// The initial count in the step timer; at standstill, the last count.
    [[nodiscard]] std::uint16_t timerCount() const { return m_count; }
    /// The integer speed; in the unprofiled modes, the nearest one.
    [[nodiscard]] unsigned speed() const { return isMoving() ? m_speed : 0; }
    /// The step rate in steps per second, negative in reverse.
    [[nodiscard]] double stepRate() const;

private:
    [[nodiscard]] bool isProfiled() const {
        return m_mode == StepperMode::Trapezoidal || m_mode == StepperMode::Velocity;
    }
    [[nodiscard]] static bool hasGoal(StepperMode mode) {
        return mode == StepperMode::Trapezoidal || mode == StepperMode::UnprofiledWithStop;
    }
    [[nodiscard]] bool isRamping() const;
    /// Phase from the present position to the goal.
    [[nodiscard]] std::int64_t phaseToGoal() const;
    /// Phase needed to slow down from `speed` to the minimum speed.
    [[nodiscard]] std::int64_t phaseToSlowDown(std::int64_t speed) const;
    [[nodiscard]] std::int64_t timeToNextEvent() const;
    void makeSteps(std::int64_t nanoseconds);
    void changeSpeed();
    void beginSlowingDown();
    void setSpeed(unsigned speed);
    void setRate(StepperRate rate);

    SpeedMode m_speedMode = SpeedMode::X8;
    std::uint8_t m_minimum = 1;

    StepperMode m_mode = StepperMode::Stopped;
    bool m_reverse = false;
    std::uint32_t m_position = 0;  ///< wraps
    std::int64_t m_stepsMade = 0;
    std::uint32_t m_goal = 0;
    StepperRate m_rate;
    std::int64_t m_phase = 0;  ///< phase since the last step
    std::uint16_t m_count = 0;

    unsigned m_speed = 0;
    unsigned m_commanded = 0;      ///< the speed that a profile ramps to
    bool m_slowingDown = false;    ///< a trapezoid that is decelerating
    bool m_peaked = false;         ///< a trapezoid too short to accelerate further
    bool m_stopAtMinimum = false;  ///< a smooth stop is in progress
    std::int64_t m_perSpeed = 0;   ///< acceleration time, ns per speed unit
    std::int64_t m_toNextSpeed = 0;
};

}  // namespace nmc::sim
