// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/module/modulestate.h"
#include "model/settings/machine.h"
#include "module/stepperspeed.h"

/// Default motion of a PIC-STEP for which nothing was set: slow, whatever motor it drives. Steps/s.
namespace nmc::stepperdefaults {

inline constexpr double kMove = 400;
inline constexpr double kRun = 200;
inline constexpr double kHold = 100;
inline constexpr double kHoldCap = 1'000;
inline constexpr std::uint8_t kAccelerationTime = 40;  ///< 10 ms from one integer speed to the next

[[nodiscard]] inline std::uint8_t accelerationTime(const AxisSettings& settings) {
    const bool set = settings.accelerationTime >= 1 && settings.accelerationTime <= 255;
    return set ? static_cast<std::uint8_t>(std::lround(settings.accelerationTime)) : kAccelerationTime;
}
/// The speed mode of the parameters in force; before any are in force, of those in the settings.
[[nodiscard]] inline StepperSpeed speedMode(const StepperState& stepper, const AxisSettings& settings) {
    if (stepper.parameters)
        return StepperSpeed(stepper.parameters->speedMode);
    return StepperSpeed(settings.parameters ? settings.parameters->speedMode : stepper::SpeedMode::X1);
}

/// The lowest speed that the chip runs in a profile (DS-S 5.1).
[[nodiscard]] inline double slowestProfile(const StepperState& stepper, const AxisSettings& settings) {
    const StepperSpeed mode = speedMode(stepper, settings);
    return stepper.parameters ? mode.ofSpeed(stepper.parameters->minimumProfileSpeed) : mode.slowest();
}
/// `speed`, limited to the fastest that the axis may move.
[[nodiscard]] inline double atMost(double speed, const AxisSettings& settings) {
    return settings.travel.fastest > 0 ? std::min(speed, settings.travel.fastest) : speed;
}
/// True if a speed that the axis may move would exceed the fastest one when the chip runs `rounded` instead.
[[nodiscard]] inline bool roundsBeyond(double speed, double rounded, const AxisSettings& settings) {
    constexpr double kGrain = 1e-6;  // absorbs the rounding of a limit that was set in the user's unit
    const double most = settings.travel.fastest + kGrain;
    return settings.travel.fastest > 0 && speed <= most && rounded > most;
}
/// The integer speed nearest to this, but the one below where only that is allowed.
[[nodiscard]] inline std::uint8_t speedFor(double speed, const StepperState& stepper,
                                           const AxisSettings& settings) {
    const StepperSpeed mode = speedMode(stepper, settings);
    const std::uint8_t nearest = mode.speedFor(speed);
    const bool below = nearest > 1 && roundsBeyond(speed, mode.ofSpeed(nearest), settings);
    return static_cast<std::uint8_t>(nearest - (below ? 1 : 0));
}
/// The timer count nearest to this, likewise.
[[nodiscard]] inline stepper::TimerCount timerFor(double speed, const StepperState& stepper,
                                                  const AxisSettings& settings) {
    const StepperSpeed mode = speedMode(stepper, settings);
    stepper::TimerCount timer = mode.timerFor(speed);
    if (timer.count > 1 && roundsBeyond(speed, mode.ofCount(timer.count), settings))
        timer.nearestSpeed = mode.speedFor(mode.ofCount(--timer.count));
    return timer;
}
[[nodiscard]] inline double holdCap(const StepperState& stepper, const AxisSettings& settings) {
    const double cap = settings.motion.holdCap > 0 ? settings.motion.holdCap : kHoldCap;
    const double slowest = slowestProfile(stepper, settings);
    return std::clamp(atMost(cap, settings), slowest,
                      std::max(slowest, speedMode(stepper, settings).fastest()));
}

}  // namespace nmc::stepperdefaults
