// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/scope/stretchfigures.h"

namespace nmc {

/// A sine in a signal. `amplitude`: from its middle to its peak, in the unit of the signal.
struct SpectrumPoint {
    double hertz = 0;
    double amplitude = 0;
};

/// The sines that make up a signal over a stretch of time (Lomb-Scargle: samples need not be evenly spaced,
/// and some may be missing). Each point is the sine of that frequency that fits best, with a Hann window, so
/// that one line is as wide as two periods per stretch to either side. Pure.
struct Spectrum {
    /// By ascending frequency, evenly spaced, from two periods per stretch to as far below half the usual
    /// rate of the samples. A faster oscillation shows at a lower frequency.
    std::vector<SpectrumPoint> points;
    /// The highest line; nothing if none stands out from the noise, which happens by chance in one of a
    /// hundred spectra.
    std::optional<SpectrumPoint> peak{};
};

/// More samples are refused, so that a spectrum takes no longer than two frames.
inline constexpr std::size_t kMostSpectrumSamples = 8'000;
inline constexpr std::size_t kFewestSpectrumSamples = 16;

/// True if nothing was sampled for so long between the points that their spectrum, whose frequencies grow in
/// number with the time from the first to the last, would take far longer. It is refused then.
[[nodiscard]] bool hasLongGap(const std::vector<SignalPoint>& points);

/// `points` must be in order of time. `derivative`: 1 for the spectrum of the signal's rate of change, per s.
/// Returns nothing if there are too few or too many points, all of them are at the same time, or they have a
/// long gap.
[[nodiscard]] std::optional<Spectrum> spectrumOf(const std::vector<SignalPoint>& points,
                                                 unsigned derivative = 0);

}  // namespace nmc
