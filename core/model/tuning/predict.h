// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>

#include "model/response/responserecord.h"
#include "model/tuning/loopmodel.h"

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

/// In the middle of a count, held by the integral, and by an error as far as that cannot. `held`: where in
/// the range that friction leaves it the integral is, -1..1.
[[nodiscard]] LoopStart standing(const MotorConstants& motor, const servo::SetGain& gains, double command,
                                 double held);

/// A step of the command from `from` to `goal`, counts, which differ, as if it had been measured: points once
/// a servo tick from the step on, as the encoder would tell, and what they are judged by; of no module and no
/// time. The shaft stood, its load carried by the integral, and by an error as far as that cannot. `record`:
/// s. `bandPercent`: of the step, as in ResponseRecord. Pure.
[[nodiscard]] ResponseRecord reckonStep(const MotorConstants& motor, const servo::SetGain& gains,
                                        std::int32_t from, std::int32_t goal, double record,
                                        double bandPercent);

struct Prediction {
    ResponseRecord run;
    double errorAtRest = 0.0;  ///< counts, at the end of the record: goal less position
    LoopMargins margins;
};

/// reckonStep() and marginsOf(); about a millisecond.
[[nodiscard]] Prediction predict(const MotorConstants& motor, const servo::SetGain& gains, std::int32_t from,
                                 std::int32_t goal, double record, double bandPercent);

}  // namespace nmc
