// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "model/response/responserecord.h"
#include "model/tuning/motormodel.h"

namespace nmc {

/// Why no motor could be identified from step responses.
enum class IdentifyFailure : std::uint8_t {
    TooFewSamples,  ///< no run, or one with fewer than kFewestSamples after its step
    DoesNotMove,    ///< the shaft does not move: jammed, no power, or friction exceeds the output
    WrongWay,       ///< it starts away from the goal: encoder or motor wired the wrong way round
    Oscillates,     ///< it oscillates without calming down
    /// The best motor differs from the measurement by far more than encoder and times explain: a hard stop,
    /// backlash, a belt, a limited current.
    NotExplained,
    Play,  ///< so much is lost at reversals that the play must exceed kMostPlay
    /// It stops abruptly from full speed, short of its goal: something is in the way.
    Obstacle,
    GainUnclear,          ///< K cannot be determined: the motor never came near a steady speed
    TimeConstantUnclear,  ///< tau cannot be determined, for the same reason
};

struct Identified {
    MotorModel motor;
    /// For each given run, the response of the motor at the times of its points.
    std::vector<std::vector<ResponsePoint>> runs;
    double missed = 0.0;    ///< counts rms, measured minus fitted
    double expected = 0.0;  ///< counts rms explained by encoder and times
};

inline constexpr std::size_t kFewestSamples = 20;
inline constexpr std::size_t kMaxRuns = 5;
inline constexpr double kMostPlay = 10.0;  ///< counts

/// Identifies the motor that best explains one to kMaxRuns step responses with the gains in force, simulated
/// tick by tick (DS-V 4.3): a least-squares fit of measured minus computed position at the samples' own times
/// (Levenberg-Marquardt). Each sample is weighted by its known errors: an encoder reports whole counts, with
/// the noise seen while the shaft stood; a time is off by up to half a tick. For each run, the fit also
/// determines and then discards when the command jumped (a tick after it was latched, or SR ticks), the
/// fraction of a count at which the shaft stood, its position within the play, and the value of the integral.
///
/// The shaft must stand before each step. Runs beyond kMaxRuns are ignored. Pure; takes some tenths of a
/// second, and three times as long when the first search explains nothing: run it as a background job.
[[nodiscard]] tl::expected<Identified, IdentifyFailure> identify(std::span<const ResponseRecord> runs);

}  // namespace nmc
