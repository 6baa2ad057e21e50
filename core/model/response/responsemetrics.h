// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <tl/expected.hpp>

namespace nmc {

/// An encoder resolves no less than a count.
inline constexpr double kHalfCount = 0.5;
/// Samples are missing between two that are farther apart than this many usual intervals: the motor may have
/// moved to and fro unseen.
inline constexpr double kSeveralIntervals = 6;
/// A mean of fewer samples means nothing.
inline constexpr std::size_t kFewestForMean = 3;

struct ResponsePoint {
    double seconds = 0.0;   ///< since the step command was latched; negative before it
    double position = 0.0;  ///< counts
    double error = 0.0;     ///< counts, command minus position; only of a profiled move
};

struct Measured {
    double value = 0.0;
    /// The true value is most likely within this distance.
    double doubt = 0.0;
};

enum class Unmeasured : std::uint8_t {
    TooFewSamples,
    NeverRose,           ///< 90 % of the step was never reached, or it never left its starting point
    NeverSettled,        ///< it was outside the band in the last part of the record
    SamplesMissing,      ///< at the place of the measurement; a repetition may help
    NoConstantVelocity,  ///< the move was too short to reach its velocity
};

/// A figure, or why there is none.
using Figure = tl::expected<Measured, Unmeasured>;

/// The figures that characterize a step response. The last part of a record is its last fifth.
///
/// Doubts. A crossing lies somewhere between two samples; linear interpolation is off by at most half their
/// interval, as long as the motor did not reverse unseen. The doubt of a rise time is therefore half an
/// interval at either end, that of a settling time half an interval, and both include the uncertainty of the
/// times themselves. The doubt of a peak is what the parabola adds to the highest sample, plus half a count;
/// that of a mean is half the range of its samples, and at least half a count. Between samples that lie
/// several usual intervals apart, the motor may have reversed unseen, so nothing is measured there.
struct ResponseMetrics {
    Figure rise;       ///< s, from 10 % to 90 % of the step
    Figure overshoot;  ///< % of the step, beyond its goal
    Figure settling;   ///< s, until it stays within the band around the goal
    /// s, until it stays within a band of the same width around its position in the last part; that position
    /// is off the goal where friction holds a motor whose loop has no integral.
    Figure settlingAtRest;
    Figure steadyError;     ///< counts: goal minus the mean position of the last part
    double interval = 0.0;  ///< s, mean interval between samples
};

/// The mean of one value of the points from one time to another, in seconds. Its doubt is half the range of
/// these values, at least `leastDoubt`.
[[nodiscard]] Figure meanOf(std::span<const ResponsePoint> points, double ResponsePoint::*value, double from,
                            double to, double leastDoubt);

/// `points` must be in order of time; those before the step are ignored. `from` and `goal` must differ.
/// `band`: counts on either side of the goal. `timeDoubt`: s, possible error of the time between two points.
[[nodiscard]] ResponseMetrics measureResponse(std::span<const ResponsePoint> points, double from, double goal,
                                              double band, double timeDoubt);

}  // namespace nmc
