// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace nmc {

/// One value of a signal, in any unit.
struct SignalPoint {
    double seconds = 0;
    double value = 0;
    bool joined = false;  ///< nothing is missing between the previous point and this one
};

/// A straight line through a signal.
struct SignalLine {
    double seconds = 0, value = 0;  ///< its centre
    double slope = 0;               ///< per second
    [[nodiscard]] double at(double when) const { return value + slope * (when - seconds); }
};
/// The least-squares line; nothing if all points have the same time.
[[nodiscard]] std::optional<SignalLine> lineThrough(const std::vector<SignalPoint>& points);

/// Characteristic figures of a signal over a stretch of time, in the unit of its points. Pure.
struct StretchFigures {
    // Time averages over the straight lines between connected points.
    double mean = 0;
    double rms = 0;
    double peakToPeak = 0;
    std::optional<double> slope{};  ///< per second, by least squares; nothing for a single moment
    /// Present for a signal that oscillates about the least-squares line at a constant rate for at least two
    /// periods with four points each, by more than its rounding.
    std::optional<double> hertz{};
};

/// `points` must be in order of time; `resolution`: the step size of their values, below which an oscillation
/// does not count. Returns nothing without points.
[[nodiscard]] std::optional<StretchFigures> figuresOf(const std::vector<SignalPoint>& points,
                                                      double resolution = 0);

}  // namespace nmc
