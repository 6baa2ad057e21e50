// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/response/responserecord.h"
#include "model/tuning/motormodel.h"

namespace nmc {

/// Stability margins of a loop: the motor without dry friction, which adds damping, with its PWM value held
/// between ticks (ZOH), and the filter as it is. Pure.
struct LoopMargins {
    double phaseDegrees = 0.0;  ///< at crossover; 180 where the gain never reaches 1; negative when unstable
    double gain = 0.0;  ///< factor by which all gains could be increased; infinite where none is too high
    double crossover = 0.0;  ///< Hz; 0 where the gain never reaches 1
    bool stable = false;     ///< every pole of the closed loop is inside the unit circle
};

/// The open-loop response (position over error) at a frequency below half the servo rate.
[[nodiscard]] std::complex<double> openLoopAt(const MotorConstants& motor, const servo::SetGain& gains,
                                              double hertz);

[[nodiscard]] LoopMargins marginsOf(const MotorConstants& motor, const servo::SetGain& gains);

/// The state at rest before a step: held by the integral, and by a position error where the integral does not
/// suffice. `held`: the integral's place in the range that friction leaves it, -1..1. `within`: the encoder's
/// place within its count, 0..1. `slack`: as in LoopStart.
[[nodiscard]] LoopStart standing(const MotorConstants& motor, const servo::SetGain& gains, double command,
                                 double held, double within = 0.5, double slack = 0.5);

/// Computes a step that begins at `start`, in counts as the encoder would report: one point per servo tick
/// from the step on, measured with a band of `bandPercent` of the step as in ResponseRecord. Pure.
[[nodiscard]] ResponseRecord reckonStep(const MotorConstants& motor, const ResponseTaken& taken,
                                        const LoopStart& start, double bandPercent);

/// A smaller fraction of the cases is not worth mentioning: two standard deviations exclude as many.
inline constexpr double kSeldom = 0.05;

/// The prediction of a step that has not been made. Each doubt is one standard deviation: the variation among
/// motors that explain the measurement equally well, and of where friction and encoder leave the shaft before
/// the step. It includes resonances that the steps would not show (MotorModel::rigidUpTo).
struct Prediction {
    /// The step of the identified motor: one point per servo tick from the step on, in encoder counts.
    ResponseRecord run;
    /// The range of positions at the same times in 95 of 100 cases.
    std::vector<ResponsePoint> low, high;
    Measured overshoot;                  ///< % of the step
    Measured settling;                   ///< s; the length of the record where it does not settle
    double unsettled = 0.0;              ///< fraction of the cases in which it does not settle, 0..1
    Measured errorAtRest;                ///< counts, goal minus position at the end of the record
    Measured phaseMargin;                ///< degrees
    std::optional<Measured> gainMargin;  ///< empty where no gain is too high
};

/// Predicts a step of the command from `from` to `goal` (counts, which must differ) over `record` seconds,
/// measured with a band of `bandPercent` as in ResponseRecord. The shaft is at rest before it, with the load
/// carried by the integral, and by a position error where the integral does not suffice. Pure; takes some
/// hundredths of a second: run it as a background job.
[[nodiscard]] Prediction predict(const MotorModel& motor, const servo::SetGain& gains, std::int32_t from,
                                 std::int32_t goal, double record, double bandPercent);

}  // namespace nmc
