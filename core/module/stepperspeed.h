// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "protocol/steppercommands.h"

/// The arithmetic of a PIC-STEP's speeds (DS-S 4.1 to 4.3): what the chip makes of a wish. Speeds in steps/s,
/// accelerations in steps/s^2. Pure.
namespace nmc {

/// What a speed mode can do.
class StepperSpeed {
public:
    explicit StepperSpeed(stepper::SpeedMode mode);

    /// 1, 2, 4 or 8.
    [[nodiscard]] int multiplier() const { return m_multiplier; }
    /// Steps/s of integer speed 1, and from one integer speed to the next (Table 3).
    [[nodiscard]] double unit() const { return 25.0 * m_multiplier; }
    /// Of the profiled modes: integer speeds 1 and 250.
    [[nodiscard]] double slowest() const { return unit(); }
    [[nodiscard]] double fastest() const;
    /// Of the unprofiled modes: timer counts 1 and 65 452.
    [[nodiscard]] double slowestTimed() const { return ofCount(1); }
    [[nodiscard]] double fastestTimed() const;

    [[nodiscard]] double ofSpeed(int speed) const { return unit() * speed; }
    [[nodiscard]] double ofCount(std::uint16_t count) const;

    /// The integer speed nearest to a wish, within 1..250.
    [[nodiscard]] std::uint8_t speedFor(double stepsPerSecond) const;
    /// The timer count nearest to a wish, within 1..65 452, with its nearest integer speed.
    [[nodiscard]] stepper::TimerCount timerFor(double stepsPerSecond) const;

    /// One unit of speed every `accelerationTime` x 0.25 ms.
    [[nodiscard]] double acceleration(int accelerationTime) const;

    bool operator==(const StepperSpeed&) const = default;

private:
    int m_multiplier;
};

/// What a trapezoidal move comes to.
struct StepperForecast {
    double seconds = 0.0;
    double peak = 0.0;        ///< steps/s
    bool triangular = false;  ///< too short to get to the speed asked for
};

/// A move of `distance` steps (its sign does not matter) from standstill: from the minimum profile speed one
/// unit more every acceleration time, up to `speed`, and down the same way. A speed below the minimum is the
/// minimum (DS-S 5.1).
[[nodiscard]] StepperForecast forecastMove(StepperSpeed mode, int minimum, int speed, int accelerationTime,
                                           double distance);

}  // namespace nmc
