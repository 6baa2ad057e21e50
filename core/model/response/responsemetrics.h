// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include <tl/expected.hpp>

namespace nmc {

struct ResponsePoint {
    double seconds = 0.0;   ///< since the step command was latched; before it negative
    double position = 0.0;  ///< counts
};

struct Measured {
    double value = 0.0;
    /// The true value is most likely not farther away than this.
    double doubt = 0.0;
};

enum class Unmeasured : std::uint8_t {
    TooFewSamples,
    NeverRose,       ///< 90 % of the step were not reached; or it did not leave where it began
    NeverSettled,    ///< it was outside the band in the last part of the record
    SamplesMissing,  ///< where it would have been measured; so a repetition helps
};

/// What a step response is judged by. The last part of a record is its last fifth.
///
/// Doubts. A crossing lies somewhere between two samples; a straight line between them finds it half their
/// interval off at worst, as long as the motor did not turn round unseen. So a rise time is uncertain by half
/// the interval at either end, a settling time by half of one, and both by what the times themselves are. A
/// peak is uncertain by what the parabola adds to the highest sample, and by half a count; a mean by half the
/// range of what it is taken from, and at least by half a count. Between samples that lie several usual
/// intervals apart it may have turned round unseen, so nothing is measured there.
struct ResponseMetrics {
    template <typename T>
    using Result = tl::expected<T, Unmeasured>;

    Result<Measured> rise;       ///< s, from 10 % to 90 % of the step
    Result<Measured> overshoot;  ///< % of the step, beyond its goal
    Result<Measured> settling;   ///< s, until it stays within the band around the goal
    /// s, until it stays within as wide a band around where it is in the last part: that is beside the goal
    /// where friction holds a motor whose loop has no integral.
    Result<Measured> settlingAtRest;
    Result<Measured> steadyError;  ///< counts: goal less the mean position of the last part
    double interval = 0.0;         ///< s, mean, between samples
};

/// `points` in the order of time, those before the step do not count; `from` and `goal` differ. `band`:
/// counts on either side of the goal. `timeDoubt`: s, by which the time between two points may be off.
[[nodiscard]] ResponseMetrics measureResponse(std::span<const ResponsePoint> points, double from, double goal,
                                              double band, double timeDoubt);

}  // namespace nmc
