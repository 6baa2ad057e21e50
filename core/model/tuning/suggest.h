// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "model/tuning/identify.h"
#include "model/tuning/predict.h"

namespace nmc {

/// What a person wants of a loop, each 0..1.
struct LoopWish {
    double stiffness = 1.0;     ///< 1: as fast as noise, output limit and margins permit; 0: a tenth of that
    double damping = 0.5;       ///< zeta, from kMinDamping to kMaxDamping
    double noise = 1.0;         ///< how loud it may be, up to kMaxNoise
    double phaseMargin = 45.0;  ///< degrees, at least; kMinPhaseMargin to kMaxPhaseMargin
};

inline constexpr double kMinDamping = 0.5;
inline constexpr double kMaxDamping = 1.1;
/// Counts by which a tick goes on when the encoder tells one count more, by way of Kd.
inline constexpr double kMaxNoise = 0.3;
inline constexpr double kMinPhaseMargin = 30.0;  ///< degrees
inline constexpr double kMaxPhaseMargin = 70.0;
/// For a motor that is not sure (MotorModel::isSure).
inline constexpr double kCarefulPhaseMargin = 60.0;
/// What a suggested loop has at least.
inline constexpr double kMinGainMargin = 2.0;

struct LoopFigures {
    double naturalFrequency = 0.0;  ///< rad/s
    double damping = 0.0;           ///< zeta
    double noise = 0.0;             ///< K Kd T^2 / (256 tau), see kMaxNoise
};

/// With T the servo tick: wn^2 = K Kp / (256 tau), 2 zeta wn = (1 + K Kd T / 256) / tau. Pure.
[[nodiscard]] LoopFigures figuresOf(const MotorConstants& motor, const servo::SetGain& gains);

/// Gains for a motor and steps of up to `step` counts (not 0; either direction), from figuresOf() the other
/// way round. SR is as low as Kd's range and resolution permit. There is an integral only if friction and
/// load would leave an error of a count; then its limit is the least that carries them, and one step of it
/// pushes no more than a count of error does. EL has a margin above the error that is predicted. `now`: the
/// gains in force; output limit, current limit and deadband compensation stay as they are.
///
/// What is suggested is stable: by its margins, and as reckoned tick by tick for the step, also with a motor
/// that is a little otherwise than was found. Nothing where no gains are. Pure; some tenths of a second, at
/// times a whole one: for a background job.
[[nodiscard]] std::optional<servo::SetGain> suggest(const MotorModel& motor, const LoopWish& wish,
                                                    const servo::SetGain& now, std::int32_t step);

}  // namespace nmc
