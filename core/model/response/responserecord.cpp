// SPDX-License-Identifier: MIT
#include "model/response/responserecord.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nmc {

namespace {

/// The uncertainty of a duration: either end is known to half a tick (bus::Sample).
constexpr Duration kTimeDoubt = kServoTick;

/// The digits beyond are those of a float, and would only fill the file.
[[nodiscard]] double thousandths(float error) {
    return std::round(static_cast<double>(error) * 1e3) / 1e3;
}

/// Returns the position unwrapped around `from`, because positions wrap at 32 bits.
[[nodiscard]] double near(std::int32_t from, std::int32_t position) {
    const auto distance = static_cast<std::uint32_t>(position) - static_cast<std::uint32_t>(from);
    return static_cast<double>(from) + static_cast<double>(static_cast<std::int32_t>(distance));
}

}  // namespace

PwmDemand pwmDemand(const servo::SetGain& gains, double errorBefore, double error) {
    const double filter = std::abs(gains.kp * error + gains.kd * (error - errorBefore));
    const double integral = static_cast<double>(gains.ki) * gains.il;
    const double wanted = std::max(0.0, filter - integral) / 256;
    return {static_cast<int>(wanted), gains.ol};
}

double ResponseRecord::band() const {
    if (taken.isMove())
        return window.counts;
    const double step = static_cast<double>(taken.goal) - static_cast<double>(taken.from);
    return std::max(1.0, std::abs(step) * bandPercent / 100);
}

double ResponseRecord::errorAt(const ResponsePoint& point) const {
    return taken.isMove() ? point.error : (point.seconds < 0 ? taken.from : taken.goal) - point.position;
}

ResponseRecord takeRun(ModuleIndex module, std::span<const ScopeSample> samples, const ResponseTaken& taken,
                       double bandPercent) {
    ResponseRecord run;
    run.module = module;
    run.taken = taken;
    for (const ScopeSample& sample : samples) {
        if (sample.time < taken.at - kBeforeStep || sample.time > taken.at + fromSeconds(taken.record))
            continue;
        if (taken.isMove() && !sample.errorKnown())
            continue;
        run.points.push_back({toSeconds(sample.time - taken.at), near(taken.from, sample.position),
                              sample.errorKnown() ? thousandths(sample.error) : 0.0});
        const double before = static_cast<double>(sample.error);
        if (!taken.isMove() && sample.time < taken.at && sample.errorKnown())
            run.pwm = pwmDemand(taken.gains, before, before + taken.goal - taken.from);
    }
    judge(run, bandPercent, run.window);
    return run;
}

void judge(ResponseRecord& run, double bandPercent, const SettleWindow& window) {
    run.bandPercent = bandPercent;
    run.window = window;
    // Positions are whole counts: the edge is half-way between the last one inside and the first one outside.
    const double edge = std::floor(run.band()) + 0.5;
    run.metrics = measureResponse(run.points, run.taken.from, run.taken.goal, edge, toSeconds(kTimeDoubt));
    if (run.taken.isMove())
        run.move = measureMove(run.points, run.taken, window, toSeconds(kTimeDoubt));
}

}  // namespace nmc
