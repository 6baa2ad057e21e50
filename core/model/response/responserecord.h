// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "model/intent/responsetaken.h"
#include "model/response/movemetrics.h"
#include "model/response/responsemetrics.h"
#include "model/scope/scopesample.h"
#include "protocol/servocommands.h"

namespace nmc {

/// The length of time shown before the step.
inline constexpr Duration kBeforeStep = std::chrono::milliseconds(20);
/// Percent; the default settling band.
inline constexpr double kFirstBand = 2.0;

/// The amplifier output that a step demands, in PWM counts (255 is full on), before deadband compensation and
/// current limiting.
struct PwmDemand {
    int wanted = 0;  ///< lower bound, as if there were no output limit
    int limit = 0;   ///< OL

    /// True if the highest output was exactly the limit. Otherwise output() is only a lower bound: a later
    /// tick may have demanded more.
    [[nodiscard]] bool limited() const { return wanted >= limit; }
    [[nodiscard]] int output() const { return limited() ? limit : wanted; }

    bool operator==(const PwmDemand&) const = default;
};

/// Computes the demand at the tick at which the command jumps: |Kp e + Kd (e - e_before)| / 256 (DS-V 4.3),
/// errors in counts. The host does not know the integral; at worst, it opposes with the full Ki x IL.
[[nodiscard]] PwmDemand pwmDemand(const servo::SetGain& gains, double errorBefore, double error);

/// A step response or a profiled move, kept for comparison with others.
struct ResponseRecord {
    ModuleIndex module;
    ResponseTaken taken;
    double bandPercent = 0.0;           ///< percent of the step, on either side of the goal
    SettleWindow window{};              ///< of a profiled move, instead of the band
    std::vector<ResponsePoint> points;  ///< from shortly before the step to the end of the record
    ResponseMetrics metrics;
    std::optional<MoveMetrics> move{};  ///< of a profiled move
    std::optional<PwmDemand> pwm{};     ///< of a step, when the position error before it was known

    /// Counts, at least one, because the encoder resolves no less.
    [[nodiscard]] double band() const;
    /// Counts, command position minus position, at one of its points.
    [[nodiscard]] double errorAt(const ResponsePoint& point) const;
};

/// `samples` are those of the module in order of time, from kBeforeStep before the step on; samples outside
/// the record are ignored, and so are those of a profiled move whose error is unknown.
[[nodiscard]] ResponseRecord takeRun(ModuleIndex module, std::span<const ScopeSample> samples,
                                     const ResponseTaken& taken, double bandPercent);

/// Measures the same run again with another band, which matters to a step, and another window, which matters
/// to a profiled move.
void judge(ResponseRecord& run, double bandPercent, const SettleWindow& window = {});

}  // namespace nmc
