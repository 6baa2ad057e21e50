// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bus/types.h"
#include "model/frequency/frequencypoint.h"
#include "protocol/servocommands.h"

namespace nmc {

/// Measures the response at one frequency: command and position are each fitted by cosine, sine, mean and
/// drift (least squares), without the first period, which the motor takes to settle in. The command is a
/// staircase, each step of which takes effect 0.512 ms after it was latched, at any servo rate: a servo that
/// samples it later does not delay its sine. Gaps of more than half a period are left out. Returns nothing
/// for fewer than kFewestPoints positions, or where the line was silent for more than half a period and
/// kSilence. Pure.
[[nodiscard]] std::optional<FrequencyPoint> measureFrequency(const bus::SineRecord& record, double hertz);
inline constexpr std::size_t kFewestPoints = 12;
inline constexpr double kSilence = 0.1;  ///< s

/// A further part of `doubt`, as one standard deviation, for a command of this amplitude: PWM values are
/// whole numbers (DS-V 4.3), and the filter's truncation, half a count on average, acts like dry friction.
/// Its fundamental is 2/pi PWM counts, relative to the filter's output for the amplitude.
[[nodiscard]] double doubtOfWholePwm(const FrequencyPoint& point, const servo::SetGain& gains,
                                     double amplitude);

/// The rate of commands on the line; 0 for fewer than two.
[[nodiscard]] double commandsPerSecond(std::span<const bus::SinePoint> commands);

/// Characteristic figures of a frequency response. Frequencies must ascend; points are joined by straight
/// lines over the logarithm of the frequency. Figures outside the measured range are empty.
struct FrequencyFigures {
    std::optional<double> bandwidth;    ///< Hz, where |T| falls below -3 dB
    std::optional<double> crossover;    ///< Hz, where |L| falls below 1
    std::optional<double> phaseMargin;  ///< degrees, -180 to 180, at crossover
    /// Factor: the least where the phase of L falls below half a turn, unless it comes back while |L| > 1.
    std::optional<double> gainMargin;
    double resonance = 0.0;  ///< dB, the highest |T|
};
[[nodiscard]] FrequencyFigures figuresOf(std::span<const FrequencyPoint> points);
/// True if a margin that was found is negative. A loop that is not is stable as far as its points reach.
[[nodiscard]] bool isUnstable(const FrequencyFigures& figures);

inline constexpr double kFaintest = -120.0;  ///< dB
/// Not below kFaintest, so that 0 can be drawn as well.
[[nodiscard]] double decibels(std::complex<double> value);
/// The range of T within two standard deviations of a point. Where the range includes 0, the phase is unknown
/// and the magnitude ends at kFaintest.
struct FrequencySpread {
    double lowest = 0.0, highest = 0.0;  ///< dB
    double degrees = 0.0;                ///< to either side of the phase
};
[[nodiscard]] FrequencySpread spreadOf(const FrequencyPoint& point);
/// Phases in degrees, each within half a turn of the previous one, so that a phase continues beyond -180. The
/// first is from -270 to 90, as a loop lags: with an integral, L may begin just beyond -180.
[[nodiscard]] std::vector<double> phases(std::span<const std::complex<double>> values);

}  // namespace nmc
