// SPDX-License-Identifier: MIT
#include "module/stepperspeed.h"

#include <algorithm>
#include <cmath>

namespace nmc {

namespace {

/// Rate of the step timer at 1x, in Hz (DS-S 4.1).
constexpr double kTimerRate = 625'000.0;
/// Timer counts that reloading takes at 1x.
constexpr double kReload = 2.0;
/// One unit of acceleration time, in seconds (DS-S 4.2).
constexpr double kTimeUnit = 0.00025;

double within(double value, ValueRange range) {
    return std::clamp(value, static_cast<double>(range.min), static_cast<double>(range.max));
}

}  // namespace

StepperSpeed::StepperSpeed(stepper::SpeedMode mode) : m_multiplier(8 >> static_cast<int>(mode)) {}

double StepperSpeed::fastest() const {
    return ofSpeed(static_cast<int>(stepper::kSpeedRange.max));
}

double StepperSpeed::fastestTimed() const {
    return ofCount(static_cast<std::uint16_t>(stepper::kTimerCountRange.max));
}

double StepperSpeed::ofCount(std::uint16_t count) const {
    return m_multiplier * kTimerRate / (65'536.0 - count + kReload * m_multiplier);
}

std::uint8_t StepperSpeed::speedFor(double stepsPerSecond) const {
    return static_cast<std::uint8_t>(within(std::round(stepsPerSecond / unit()), stepper::kSpeedRange));
}

std::uint8_t StepperSpeed::speedBelow(double stepsPerSecond) const {
    constexpr double kGrain = 1e-9;  // absorbs the rounding of a speed that is a whole number of units
    return static_cast<std::uint8_t>(
        within(std::floor(stepsPerSecond / unit() + kGrain), stepper::kSpeedRange));
}

stepper::TimerCount StepperSpeed::timerFor(double stepsPerSecond) const {
    const double slowest = std::max(stepsPerSecond, slowestTimed());
    const double exact = 65'536.0 + kReload * m_multiplier - m_multiplier * kTimerRate / slowest;
    const auto below = static_cast<std::uint16_t>(within(std::floor(exact), stepper::kTimerCountRange));
    const auto above = static_cast<std::uint16_t>(within(std::floor(exact) + 1, stepper::kTimerCountRange));
    // Nearest in speed, not in count: at high speeds, one count is a large step in speed.
    const bool up = std::abs(ofCount(above) - stepsPerSecond) < std::abs(ofCount(below) - stepsPerSecond);
    const std::uint16_t count = up ? above : below;
    return {count, speedFor(ofCount(count))};
}

double StepperSpeed::acceleration(int accelerationTime) const {
    return unit() / (kTimeUnit * accelerationTime);
}

StepperForecast forecastMove(StepperSpeed mode, int minimum, int speed, int accelerationTime,
                             double distance) {
    const double steps = std::abs(distance);
    if (steps == 0.0)
        return {};
    const double dwell = kTimeUnit * accelerationTime;
    // One acceleration time at each speed from the minimum to the one before `top`.
    const auto ramp = [&](int top) {
        return dwell * mode.unit() * (top - minimum) * (top - 1 + minimum) / 2.0;
    };
    const int wanted = std::max(speed, minimum);
    int top = wanted;
    while (top > minimum && 2.0 * ramp(top) > steps)
        --top;
    StepperForecast forecast;
    forecast.peak = mode.ofSpeed(top);
    forecast.triangular = top < wanted;
    forecast.seconds = 2.0 * dwell * (top - minimum) + (steps - 2.0 * ramp(top)) / forecast.peak;
    return forecast;
}

}  // namespace nmc
