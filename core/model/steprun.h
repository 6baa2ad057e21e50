// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/strong.h"
#include "model/pwmdemand.h"
#include "model/scopesample.h"
#include "model/stepmetrics.h"
#include "model/steptaken.h"

namespace nmc {

/// A step response as it is kept to be compared with others.
struct StepRun {
    ModuleIndex module;
    StepTaken taken;
    double bandPercent = 0.0;       ///< of the step, on either side of the goal
    std::vector<StepPoint> points;  ///< from shortly before the step to the end of the record
    StepMetrics metrics;
    std::optional<PwmDemand> pwm;  ///< where the position error before the step was known

    /// Counts; not below one, since the encoder tells no less.
    [[nodiscard]] double band() const;
};

/// `samples` of that module, in the order of time; those outside the record do not count.
[[nodiscard]] StepRun takeRun(ModuleIndex module, std::span<const ScopeSample> samples,
                              const StepTaken& taken, double bandPercent);

/// The same run judged by another band.
void setBand(StepRun& run, double bandPercent);

}  // namespace nmc
