// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bus/types.h"
#include "model/frequency/frequencypoint.h"
#include "protocol/servocommands.h"

namespace nmc {

/// What the positions tell of that frequency: command and position are each fitted by cosine, sine, mean and
/// drift (least squares), without the first period, which the motor takes to get used to it. The command is a
/// staircase; the chip sees each of its steps one servo tick after it was latched, `tick` seconds. What was
/// not told for half a period does not count. Nothing for fewer than kFewestPoints positions, or where the
/// line was silent for that long and kSilence. Pure.
[[nodiscard]] std::optional<FrequencyPoint> measureFrequency(const bus::SineRecord& record, double hertz,
                                                             double tick);
inline constexpr std::size_t kFewestPoints = 12;
inline constexpr double kSilence = 0.1;  ///< s

/// What `doubt` has besides, as one standard deviation, for a command of that amplitude: PWM values are whole
/// (DS-V 4.3), and what the filter cuts off of them, half a count on average, is like dry friction. Its
/// fundamental is 2/pi PWM counts of what the filter makes of the amplitude.
[[nodiscard]] double doubtOfWholePwm(const FrequencyPoint& point, const servo::SetGain& gains,
                                     double amplitude);

/// What the line carried; 0 for fewer than two.
[[nodiscard]] double commandsPerSecond(std::span<const bus::SinePoint> commands);

/// What a frequency response comes down to. Frequencies ascend; straight lines between points, over the
/// logarithm of the frequency. What lies outside of what was measured is not there.
struct FrequencyFigures {
    std::optional<double> bandwidth;    ///< Hz, where |T| falls below -3 dB
    std::optional<double> crossover;    ///< Hz, where |L| falls below 1
    std::optional<double> phaseMargin;  ///< degrees, there
    std::optional<double> gainMargin;   ///< times, where L is half a turn behind
    double resonance = 0.0;             ///< dB, the highest |T|
};
[[nodiscard]] FrequencyFigures figuresOf(std::span<const FrequencyPoint> points);

[[nodiscard]] double decibels(std::complex<double> value);
/// What two standard deviations of a point leave open of T. Where they reach 0 its phase is not known, and
/// its magnitude ends at kFaintest.
struct FrequencySpread {
    double lowest = 0.0, highest = 0.0;  ///< dB
    double degrees = 0.0;                ///< to either side
};
[[nodiscard]] FrequencySpread spreadOf(const FrequencyPoint& point);
inline constexpr double kFaintest = -120.0;  ///< dB
/// Degrees, each within half a turn of the one before, so that a phase goes on beyond -180; from the first
/// one's own.
[[nodiscard]] std::vector<double> phases(std::span<const std::complex<double>> values);

}  // namespace nmc
