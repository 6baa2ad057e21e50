// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/tuning/identify.h"
#include "model/tuning/predict.h"

namespace nmc {

/// What a person wants of a loop, each 0..1.
struct LoopWish {
    double stiffness = 0.5;  ///< 1: the fastest that noise, output limit and margins permit
    double damping = 0.5;    ///< of zeta from kLeastDamping to kMostDamping
    double noise = 0.5;      ///< how loud it may be: of kMostNoise
};

inline constexpr double kLeastDamping = 0.6;
inline constexpr double kMostDamping = 1.4;
/// Counts by which one count of the encoder moves the motor in a tick, by way of Kd: K Kd T^2 / (256 tau).
inline constexpr double kMostNoise = 0.3;

[[nodiscard]] double noiseOf(const MotorConstants& motor, const servo::SetGain& gains);

/// Gains and why they are what they are.
struct Suggestion {
    servo::SetGain gains;
    double stiffness = 0.0;  ///< natural frequency, rad/s
    double damping = 0.0;    ///< zeta
    double noise = 0.0;      ///< noiseOf
};

/// Gains for a motor, for steps of up to `step` counts: with T the servo tick,
///
///     wn^2 = K Kp / (256 tau)        2 zeta wn = (1 + K Kd T / 256) / tau
///
/// SR as low as Kd's resolution permits; an integral only if friction and load would leave an error of a
/// count, and then no larger than carries them; EL above the error that is predicted. `now`: the gains in
/// force; their output limit, current limit and deadband compensation stay. What is suggested is stable:
/// every pole within the unit circle, and the step, reckoned tick by tick, calms down. Nothing where no gains
/// do that. Pure; some milliseconds.
[[nodiscard]] std::optional<Suggestion> suggest(const MotorModel& motor, const LoopWish& wish,
                                                const servo::SetGain& now, double step);

}  // namespace nmc
