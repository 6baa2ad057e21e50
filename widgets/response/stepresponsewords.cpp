// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/stepresponsewords.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

class StepTexts {
    Q_DECLARE_TR_FUNCTIONS(StepTexts)
};

QString unmeasured(Unmeasured why) {
    switch (why) {
        case Unmeasured::TooFewSamples:
            return StepTexts::tr("too few samples");
        case Unmeasured::NeverRose:
            return StepTexts::tr("did not reach 90 %");
        case Unmeasured::SamplesMissing:
            return StepTexts::tr("samples missing, repeat");
        case Unmeasured::NeverSettled:
            return StepTexts::tr("not recorded");
    }
    return {};
}

Measured times(const Measured& measured, double factor) {
    return {measured.value * factor, measured.doubt * factor};
}

QString number(double value, int decimals) {
    const QString digits = QLocale().toString(std::abs(value), 'f', decimals);
    const bool zero = std::abs(value) * std::pow(10, decimals) < 0.5;
    return value < 0 && !zero ? QChar(0x2212) + digits : digits;
}

}  // namespace

QString stepWay(StepWay way) {
    switch (way) {
        case StepWay::Profile:
            return StepTexts::tr("Very fast profile");
        case StepWay::StopHere:
            return StepTexts::tr("Stop here, at the goal");
    }
    return {};
}

QString stepWayMeaning(StepWay way) {
    switch (way) {
        case StepWay::Profile:
            return StepTexts::tr(
                "A move with so much velocity and acceleration that the profile reaches the goal in one tick.");
        case StepWay::StopHere:
            return StepTexts::tr("The servo holds the goal at once, without a profile. Not with version 1.");
    }
    return {};
}

QString plusMinus(const Measured& measured, const QString& unit) {
    constexpr int kMost = 6;
    const double doubt = std::max(measured.doubt, 1e-9);
    int decimals = -static_cast<int>(std::floor(std::log10(doubt)));
    // 0.1 says much less than 0.14.
    if (doubt * std::pow(10, decimals) < 2)
        ++decimals;
    decimals = std::clamp(decimals, 0, kMost);
    // Rounded up: no more certain than it is.
    const double power = std::pow(10, decimals);
    const double shown = std::ceil(doubt * power - 1e-6) / power;
    return u"%1 ± %2 %3"_s.arg(number(measured.value, decimals), number(shown, decimals), unit);
}

QString stepTime(const StepMetrics::Result<Measured>& seconds) {
    if (!seconds)
        return unmeasured(seconds.error());
    return seconds->value < 1 ? plusMinus(times(*seconds, 1e3), StepTexts::tr("ms"))
                              : plusMinus(*seconds, StepTexts::tr("s"));
}

QString stepSettling(const StepMetrics& metrics) {
    const bool beside = !metrics.settling && metrics.settlingAtRest;
    return beside ? StepTexts::tr("%1, off its goal").arg(stepTime(metrics.settlingAtRest))
                  : stepTime(metrics.settling);
}

QString stepOvershoot(const StepMetrics::Result<Measured>& percent) {
    return percent ? plusMinus(*percent, u"%"_s) : unmeasured(percent.error());
}

QString stepError(const StepMetrics::Result<Measured>& counts, const AxisScale& scale) {
    return counts ? plusMinus(times(*counts, scale.position(1.0)), unitOf(scale))
                  : unmeasured(counts.error());
}

QString peakPwm(const std::optional<PwmDemand>& demand) {
    if (!demand)
        return StepTexts::tr("unknown");
    return (demand->limited() ? StepTexts::tr("limited to %1") : StepTexts::tr("at least %1"))
        .arg(demand->output());
}

}  // namespace nmc::texts
