// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsewords.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

class ResponseTexts {
    Q_DECLARE_TR_FUNCTIONS(ResponseTexts)
};

QString unmeasured(Unmeasured why) {
    switch (why) {
        case Unmeasured::TooFewSamples:
            return ResponseTexts::tr("too few samples");
        case Unmeasured::NeverRose:
            return ResponseTexts::tr("did not reach 90 %");
        case Unmeasured::SamplesMissing:
            return ResponseTexts::tr("samples missing, repeat");
        case Unmeasured::NeverSettled:
            return ResponseTexts::tr("not recorded");
        case Unmeasured::NoConstantVelocity:
            return ResponseTexts::tr("never constant");
    }
    return {};
}

Measured times(const Measured& measured, double factor) {
    return {measured.value * factor, measured.doubt * factor};
}

}  // namespace

QString responseMethod(ResponseMethod method) {
    switch (method) {
        case ResponseMethod::Profile:
            return ResponseTexts::tr("Very fast profile");
        case ResponseMethod::StopHere:
            return ResponseTexts::tr("Stop here, at the goal");
        case ResponseMethod::Move:
            return ResponseTexts::tr("Profiled move");
    }
    return {};
}

QString responseMethodMeaning(ResponseMethod method) {
    switch (method) {
        case ResponseMethod::Profile:
            return ResponseTexts::tr(
                "A move with velocity and acceleration so high that its profile reaches the goal in one servo tick. CMC and SC stop here, at the goal, instead.");
        case ResponseMethod::StopHere:
            return ResponseTexts::tr(
                "The servo holds the goal at once, without a profile. Not available with version 1.");
        case ResponseMethod::Move:
            return ResponseTexts::tr(
                "No step: moves there and back with the velocity and acceleration below, judged by a window and a dwell. Not available with version 1.");
    }
    return {};
}

QString plusMinus(const Measured& measured) {
    constexpr int kMax = 6;
    const double doubt = std::max(measured.doubt, 1e-9);
    int decimals = -static_cast<int>(std::floor(std::log10(doubt)));
    // 0.1 is much less precise than 0.14.
    if (doubt * std::pow(10, decimals) < 2)
        ++decimals;
    decimals = std::clamp(decimals, 0, kMax);
    // Rounded up, so that the value does not look more certain than it is.
    const double power = std::pow(10, decimals);
    const double shown = std::ceil(doubt * power - 1e-6) / power;
    return u"%1 ± %2"_s.arg(fixed(measured.value, decimals), fixed(shown, decimals));
}

QString plusMinus(const Measured& measured, const QString& unit) {
    return plusMinus(measured) + u' ' + unit;
}

QString responseTime(const Figure& seconds) {
    if (!seconds)
        return unmeasured(seconds.error());
    return seconds->value < 1 ? plusMinus(times(*seconds, 1e3), Common::tr("ms"))
                              : plusMinus(*seconds, Common::tr("s"));
}

QString responseSettling(const ResponseRecord& run) {
    if (run.move)
        return responseTime(run.move->settling);
    const ResponseMetrics& metrics = run.metrics;
    const bool beside = !metrics.settling && metrics.settlingAtRest;
    return beside ? ResponseTexts::tr("%1, off its goal").arg(responseTime(metrics.settlingAtRest))
                  : responseTime(metrics.settling);
}

QString settlingSpread(const std::vector<const KeptResponse*>& moves) {
    double least = 0, most = 0;
    std::size_t settled = 0;
    for (const KeptResponse* kept : moves) {
        const auto& move = kept->run.move;
        if (!move || !move->settling)
            continue;
        const double seconds = move->settling->value;
        least = settled == 0 ? seconds : std::min(least, seconds);
        most = std::max(most, seconds);
        ++settled;
    }
    if (settled < moves.size())
        return ResponseTexts::tr("%1 of %2 settled").arg(settled).arg(moves.size());
    return ResponseTexts::tr("%1 to %2 ms (%3)")
        .arg(fixed(least * 1e3, 1), fixed(most * 1e3, 1))
        .arg(moves.size());
}

QString responseOvershoot(const Figure& percent) {
    return percent ? plusMinus(*percent, u"%"_s) : unmeasured(percent.error());
}

QString responseError(const Figure& counts, const AxisScale& scale) {
    return counts ? plusMinus({scale.position(counts->value), scale.distance(counts->doubt)}, unitOf(scale))
                  : unmeasured(counts.error());
}

QString responseErrorSize(const Figure& counts, const AxisScale& scale) {
    return counts ? plusMinus(times(*counts, scale.distance(1.0)), unitOf(scale))
                  : unmeasured(counts.error());
}

QString peakPwm(const std::optional<PwmDemand>& demand) {
    if (!demand)
        return ResponseTexts::tr("unknown");
    return (demand->limited() ? ResponseTexts::tr("limited to %1") : ResponseTexts::tr("at least %1"))
        .arg(demand->output());
}

}  // namespace nmc::texts
