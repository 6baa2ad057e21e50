// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "protocol/steppercommands.h"

/// The arithmetic of a PIC-STEP's speeds (DS-S 4.1 to 4.3): the values that the chip can run for those
/// requested. Speeds in steps/s, accelerations in steps/s^2. Pure.
namespace nmc {

/// The capabilities of a speed mode.
class StepperSpeed {
public:
    explicit StepperSpeed(stepper::SpeedMode mode);

    /// The speed multiplier: 1, 2, 4 or 8.
    [[nodiscard]] int multiplier() const { return m_multiplier; }
    /// Integer speed 1 in steps/s, which is also the distance between integer speeds (Table 3).
    [[nodiscard]] double unit() const { return 25.0 * m_multiplier; }
    /// The speed range of profiled modes: integer speeds 1 and 250.
    [[nodiscard]] double slowest() const { return unit(); }
    [[nodiscard]] double fastest() const;
    /// The speed range of unprofiled modes: timer counts 1 and 65 452.
    [[nodiscard]] double slowestTimed() const { return ofCount(1); }
    [[nodiscard]] double fastestTimed() const;

    [[nodiscard]] double ofSpeed(int speed) const { return unit() * speed; }
    [[nodiscard]] double ofCount(std::uint16_t count) const;

    /// The integer speed nearest to the requested one, within 1..250.
    [[nodiscard]] std::uint8_t speedFor(double stepsPerSecond) const;
    /// The highest integer speed that is not above the requested one, within 1..250.
    [[nodiscard]] std::uint8_t speedBelow(double stepsPerSecond) const;
    /// The timer count nearest to the requested speed, within 1..65 452, with its nearest integer speed.
    [[nodiscard]] stepper::TimerCount timerFor(double stepsPerSecond) const;

    /// The acceleration in steps/s^2: one unit of speed every `accelerationTime` x 0.25 ms.
    [[nodiscard]] double acceleration(int accelerationTime) const;

    bool operator==(const StepperSpeed&) const = default;

private:
    int m_multiplier;
};

/// The predicted duration and peak speed of a trapezoidal move.
struct StepperForecast {
    double seconds = 0.0;
    double peak = 0.0;        ///< steps/s
    bool triangular = false;  ///< too short to reach the requested speed
};

/// Predicts a move of `distance` steps (its sign does not matter) from standstill: it starts at the minimum
/// profile speed, gains one unit every acceleration time up to `speed`, and slows down in the same way. A
/// speed below the minimum counts as the minimum (DS-S 5.1).
[[nodiscard]] StepperForecast forecastMove(StepperSpeed mode, int minimum, int speed, int accelerationTime,
                                           double distance);

}  // namespace nmc
