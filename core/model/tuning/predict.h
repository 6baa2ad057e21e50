// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/response/responserecord.h"
#include "model/tuning/motormodel.h"

namespace nmc {

/// How far a loop is from instability: of the motor without its dry friction, which calms it further, its PWM
/// held between ticks (ZOH), and the filter as it is. Pure.
struct LoopMargins {
    double phaseDegrees = 0.0;  ///< at crossover; 180 where the gain never reaches 1; below 0 it is unstable
    double gain = 0.0;       ///< how many times higher all gains could be; infinite where nothing is too high
    double crossover = 0.0;  ///< Hz; 0 where the gain never reaches 1
    bool stable = false;     ///< every pole of the closed loop is inside the unit circle
};

/// What the same loop makes of its error at a frequency below half the servo rate.
[[nodiscard]] std::complex<double> openLoopAt(const MotorConstants& motor, const servo::SetGain& gains,
                                              double hertz);

[[nodiscard]] LoopMargins marginsOf(const MotorConstants& motor, const servo::SetGain& gains);

/// Held by the integral, and by an error as far as that cannot. `held`: where in the range that friction
/// leaves it the integral is, -1..1. `within`: where in its count the encoder is, 0..1. `slack`: as in
/// LoopStart.
[[nodiscard]] LoopStart standing(const MotorConstants& motor, const servo::SetGain& gains, double command,
                                 double held, double within = 0.5, double slack = 0.5);

/// In counts, as the encoder would tell, of a step that `start` comes before: points once a servo tick from
/// the step on, judged by a band of `bandPercent` of the step as in ResponseRecord. Pure.
[[nodiscard]] ResponseRecord reckonStep(const MotorConstants& motor, const ResponseTaken& taken,
                                        const LoopStart& start, double bandPercent);

/// Less than this part of the cases is not worth a word: two standard deviations leave out as many.
inline constexpr double kSeldom = 0.05;

/// A step that has not been made. Each doubt is one standard deviation: how the figure varies with motors
/// that explain what was measured as well, and with where friction and encoder leave the shaft before the
/// step. They count in what may resonate where the steps do not show it (MotorModel::rigidUpTo).
struct Prediction {
    /// The step of the motor that was found: a point for each servo tick from the step on, in encoder counts.
    ResponseRecord run;
    /// Where the motor is at the same times in 95 of 100 cases.
    std::vector<ResponsePoint> low, high;
    Measured overshoot;                  ///< % of the step
    Measured settling;                   ///< s; the record where it does not settle
    double unsettled = 0.0;              ///< part of the cases in which it does not settle, 0..1
    Measured errorAtRest;                ///< counts, at the end of the record: goal less position
    Measured phaseMargin;                ///< degrees
    std::optional<Measured> gainMargin;  ///< empty where no gain is too high
};

/// A step of the command from `from` to `goal`, counts, which differ, of `record` seconds, judged by a band
/// of `bandPercent` as in ResponseRecord. The shaft stood, its load carried by the integral, and by an error
/// as far as that cannot. Pure; some hundredths of a second: for a background job.
[[nodiscard]] Prediction predict(const MotorModel& motor, const servo::SetGain& gains, std::int32_t from,
                                 std::int32_t goal, double record, double bandPercent);

}  // namespace nmc
