// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace nmc {

/// One value of a signal, in any unit.
struct SignalPoint {
    double seconds = 0;
    double value = 0;
    bool joined = false;  ///< nothing is missing between the point before and this one
};

/// What a signal comes to over a stretch of time, in the unit of its points. Pure.
struct StretchFigures {
    // Of the straight lines between points that are joined, over time.
    double mean = 0;
    double rms = 0;
    double peakToPeak = 0;
    std::optional<double> slope{};  ///< each second, by least squares; nothing of a single moment
    /// Of a signal that swings about the line of least squares at one rate for two periods at least, with
    /// four points in each, and by more than rounding does.
    std::optional<double> hertz{};

    bool operator==(const StretchFigures&) const = default;
};

/// `points` in the order of time; `resolution`: the step in which their values go, of which a swing is none.
/// Nothing of no points.
[[nodiscard]] std::optional<StretchFigures> figuresOf(const std::vector<SignalPoint>& points,
                                                      double resolution = 0);

}  // namespace nmc
