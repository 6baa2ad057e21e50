// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "model/response/responserecord.h"
#include "model/tuning/motormodel.h"

namespace nmc {

/// Why step responses give no motor.
enum class IdentifyFailure : std::uint8_t {
    TooFewSamples,  ///< no run, or one with fewer than kFewestSamples after its step
    DoesNotMove,    ///< the shaft stays where it was: jammed, no power, friction stronger than the output
    WrongWay,       ///< it starts away from the goal: encoder or motor connected the wrong way round
    Oscillates,     ///< it swings and does not calm down
    /// The best motor there is misses what was measured by far more than the encoder and the times explain:
    /// a hard stop, backlash, a belt, a limited current.
    NotExplained,
    Play,  ///< so much is lost where it turns round that there must be more than kMostPlay of it
    /// It stops dead short of its goal, out of full speed: something is in the way.
    Obstacle,
    GainUnclear,          ///< K may be anything: nowhere did the motor come near a steady speed
    TimeConstantUnclear,  ///< so may tau
};

/// A run and what the motor that was found would have done.
struct FittedRun {
    std::vector<ResponsePoint> points;  ///< at the times of the run's own, one for each
    double start = 0.0;                 ///< s after ResponseTaken::at, when the chip's command jumped
    double integral = 0.0;              ///< counts: the running sum over 256, before the step
};

struct Identified {
    MotorModel motor;
    std::vector<FittedRun> runs;  ///< one for each that was given
    double missed = 0.0;          ///< counts, rms: measured less fitted
    double expected = 0.0;        ///< counts, rms: what encoder and times explain
};

inline constexpr std::size_t kFewestSamples = 20;
inline constexpr std::size_t kMaxRuns = 5;
inline constexpr double kMostPlay = 10.0;  ///< counts

/// The motor that explains one to kMaxRuns step responses best, by their gains in force, tick by tick
/// (DS-V 4.3): least squares of measured less reckoned position at the samples' own times
/// (Levenberg-Marquardt), each weighted by what is known of it: an encoder tells whole counts, and varies as
/// it did where the shaft stood; a time is off by up to half a tick. Found for each run as well, and
/// forgotten: when the command jumped (a tick after it was latched, or SR of them), the part of a count at
/// which the shaft stood, where in its play, and what the integral held.
///
/// The shaft stood before each step. Runs beyond kMaxRuns are not looked at. Pure; some tenths of a second,
/// three times that where the first search explains nothing: for a background job.
[[nodiscard]] tl::expected<Identified, IdentifyFailure> identify(std::span<const ResponseRecord> runs);

}  // namespace nmc
