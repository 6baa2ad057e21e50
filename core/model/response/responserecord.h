// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "model/intent/responsetaken.h"
#include "model/module/pwmdemand.h"
#include "model/response/responsemetrics.h"
#include "model/scope/scopesample.h"

namespace nmc {

/// What a run shows of the time before its step.
inline constexpr Duration kBeforeStep = std::chrono::milliseconds(20);
/// Percent; the usual settling band.
inline constexpr double kFirstBand = 2.0;

/// A step response as it is kept to be compared with others.
struct ResponseRecord {
    ModuleIndex module;
    ResponseTaken taken;
    double bandPercent = 0.0;           ///< of the step, on either side of the goal
    std::vector<ResponsePoint> points;  ///< from shortly before the step to the end of the record
    ResponseMetrics metrics;
    std::optional<PwmDemand> pwm;  ///< where the position error before the step was known

    /// Counts; not below one, since the encoder tells no less.
    [[nodiscard]] double band() const;
};

/// `samples` of that module, in the order of time, from kBeforeStep before the step on; those outside the
/// record do not count.
[[nodiscard]] ResponseRecord takeRun(ModuleIndex module, std::span<const ScopeSample> samples,
                                     const ResponseTaken& taken, double bandPercent);

/// The same run judged by another band.
void setBand(ResponseRecord& run, double bandPercent);

}  // namespace nmc
