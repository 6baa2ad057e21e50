// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/response/stepmetrics.h"
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

[[nodiscard]] LoopMargins marginsOf(const MotorConstants& motor, const servo::SetGain& gains);

/// What a step would look like, and what it is judged by.
struct Prediction {
    std::vector<StepPoint> points;  ///< once a servo tick from the step on, as the encoder would tell
    StepMetrics metrics;            ///< as of a measured run
    double errorAtRest = 0.0;       ///< counts at the end of the record: command less position
    double largestError = 0.0;      ///< counts, of any tick; at least the step
    double largestPwm = 0.0;        ///< PWM counts
    LoopMargins margins;
};

/// A step from standstill at `from`, load carried by the integral as far as it can. `record`: s.
/// `bandPercent`: of the step, as in StepRun. Well under a millisecond for half a second. Pure.
[[nodiscard]] Prediction predict(const MotorConstants& motor, const servo::SetGain& gains, double from,
                                 double goal, double record, double bandPercent);

}  // namespace nmc
