// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/tuning/identify.h"
#include "model/tuning/predict.h"

namespace nmc {

/// The user's preferences for a loop, each 0..1.
struct LoopWish {
    double stiffness = 1.0;     ///< 1: as fast as noise, output limit and margins permit; 0: a tenth of that
    double damping = 0.5;       ///< zeta, mapped to kMinDamping to kMaxDamping
    double noise = 1.0;         ///< permitted noise, as a fraction of kMaxNoise
    double phaseMargin = 45.0;  ///< degrees, minimum; kMinPhaseMargin to kMaxPhaseMargin
};

inline constexpr double kMinDamping = 0.5;
inline constexpr double kMaxDamping = 1.1;
/// Counts that the motor moves in a tick when the encoder reading changes by one count, through Kd.
inline constexpr double kMaxNoise = 0.3;
inline constexpr double kMinPhaseMargin = 30.0;  ///< degrees
inline constexpr double kMaxPhaseMargin = 70.0;
/// For a motor whose model is not sure (MotorModel::isSure).
inline constexpr double kCarefulPhaseMargin = 60.0;
/// The minimum gain margin of a suggested loop.
inline constexpr double kMinGainMargin = 2.0;

/// The noise of a loop, see kMaxNoise: K Kd T^2 / (256 tau), with T the servo tick. Pure.
[[nodiscard]] double noiseOf(const MotorConstants& motor, const servo::SetGain& gains);

/// Suggests gains for a motor and steps of up to `step` counts (not 0; either direction), by inverting
/// wn^2 = K Kp / (256 tau) and 2 zeta wn = (1 + K Kd T / 256) / tau. SR is as low as Kd's range and
/// resolution permit. An integral is used only if friction and load would leave an error of a count; its
/// limit is then the least that carries them, and one increment of it drives no more than one count of error
/// does. EL has a margin above the predicted error. `now`: the gains in force; output limit, current limit
/// and deadband compensation are kept.
///
/// The suggestion is stable, both by its margins and when simulated tick by tick for the step, including
/// motors that differ a little from the identified one. Returns nothing when no gains qualify. Pure; takes
/// some tenths of a second, at times a whole second: run it as a background job.
[[nodiscard]] std::optional<servo::SetGain> suggest(const MotorModel& motor, const LoopWish& wish,
                                                    const servo::SetGain& now, std::int32_t step);

}  // namespace nmc
