// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsewords.h"

#include <QCoreApplication>
#include <QLocale>
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

QString responseMethod(ResponseMethod method) {
    switch (method) {
        case ResponseMethod::Profile:
            return ResponseTexts::tr("Very fast profile");
        case ResponseMethod::StopHere:
            return ResponseTexts::tr("Stop here, at the goal");
    }
    return {};
}

QString responseMethodMeaning(ResponseMethod method) {
    switch (method) {
        case ResponseMethod::Profile:
            return ResponseTexts::tr(
                "A move with velocity and acceleration so high that its profile reaches the goal in one servo tick.");
        case ResponseMethod::StopHere:
            return ResponseTexts::tr(
                "The servo holds the goal at once, without a profile. Not available with version 1.");
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
    return u"%1 ± %2"_s.arg(number(measured.value, decimals), number(shown, decimals));
}

QString plusMinus(const Measured& measured, const QString& unit) {
    return plusMinus(measured) + u' ' + unit;
}

QString responseTime(const ResponseMetrics::Result<Measured>& seconds) {
    if (!seconds)
        return unmeasured(seconds.error());
    return seconds->value < 1 ? plusMinus(times(*seconds, 1e3), Common::tr("ms"))
                              : plusMinus(*seconds, Common::tr("s"));
}

QString responseSettling(const ResponseMetrics& metrics) {
    const bool beside = !metrics.settling && metrics.settlingAtRest;
    return beside ? ResponseTexts::tr("%1, off its goal").arg(responseTime(metrics.settlingAtRest))
                  : responseTime(metrics.settling);
}

QString responseOvershoot(const ResponseMetrics::Result<Measured>& percent) {
    return percent ? plusMinus(*percent, u"%"_s) : unmeasured(percent.error());
}

QString responseError(const ResponseMetrics::Result<Measured>& counts, const AxisScale& scale) {
    return counts ? plusMinus(times(*counts, scale.position(1.0)), unitOf(scale))
                  : unmeasured(counts.error());
}

QString peakPwm(const std::optional<PwmDemand>& demand) {
    if (!demand)
        return ResponseTexts::tr("unknown");
    return (demand->limited() ? ResponseTexts::tr("limited to %1") : ResponseTexts::tr("at least %1"))
        .arg(demand->output());
}

}  // namespace nmc::texts
