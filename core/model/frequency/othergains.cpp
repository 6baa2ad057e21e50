// SPDX-License-Identifier: MIT
#include "model/frequency/othergains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/time.h"

namespace nmc {

namespace {

using Complex = std::complex<double>;

/// The fraction of the output that OL may cut off: it makes the loop weaker by less than half a decibel.
constexpr double kCutOff = 0.05;
/// The fraction of |C| from which the integral matters: without it, C is off by at most 1 dB and 6 degrees.
constexpr double kMatters = 0.1;

[[nodiscard]] Complex integralAt(const servo::SetGain& gains, double hertz) {
    const double tick = secondsPerTick(gains.sr);
    const Complex change = 1.0 - std::polar(1.0, -2 * std::numbers::pi * hertz * tick);
    return gains.il > 0 ? gains.ki / 256.0 / change : 0.0;
}

/// The output is highest right after each command, whose reply has the position at that moment. What the
/// integral adds steadily is not known, and left out.
[[nodiscard]] bool meetsOutputLimit(const bus::SineRecord& record, const servo::SetGain& gains) {
    if (record.answers.size() != record.commands.size())
        return true;
    double wanted = 0.0;
    double cutOff = 0.0;
    for (std::size_t i = 1; i < record.commands.size(); ++i) {
        const double error = record.commands[i].counts - record.answers[i].counts;
        const double jump = record.commands[i].counts - record.commands[i - 1].counts;
        const double output = std::abs(gains.kp * error + gains.kd * jump) / 256;
        wanted += output;
        cutOff += std::max(0.0, output - gains.ol);
    }
    return cutOff > kCutOff * wanted;
}

/// An integral that could drive more than OL besides its own swing is never at its limit.
[[nodiscard]] bool meetsIntegralLimit(const FrequencyPoint& point, const servo::SetGain& gains,
                                      double amplitude) {
    const double integral = std::abs(integralAt(gains, point.hertz));
    const double swing = integral * amplitude * std::abs(1.0 - point.closed);
    return integral > kMatters * std::abs(filterAt(gains, point.hertz)) &&
           (1.0 * gains.ki * gains.il - swing) / 256 < gains.ol;
}

}  // namespace

Complex filterAt(const servo::SetGain& gains, double hertz) {
    const double tick = secondsPerTick(gains.sr);
    const Complex change = 1.0 - std::polar(1.0, -2 * std::numbers::pi * hertz * tick);
    return 1.0 * gains.kp + 1.0 * gains.kd * change + integralAt(gains, hertz);
}

bool meetsLimits(const bus::SineRecord& record, const FrequencyPoint& point, const servo::SetGain& gains,
                 double amplitude) {
    return meetsOutputLimit(record, gains) || meetsIntegralLimit(point, gains, amplitude);
}

LoopChange changeOf(const servo::SetGain& from, const servo::SetGain& to) {
    if (from.sr != to.sr)
        return LoopChange::Rate;
    if (from.db.value_or(0) != to.db.value_or(0))
        return LoopChange::Deadband;
    const auto integral = [](const servo::SetGain& gains) { return gains.il > 0 ? gains.ki : 0; };
    const bool same = from.kp == to.kp && from.kd == to.kd && integral(from) == integral(to);
    return same ? LoopChange::None : LoopChange::Filter;
}

std::vector<FrequencyPoint> withOtherGains(std::span<const FrequencyPoint> measured,
                                           const servo::SetGain& from, const servo::SetGain& to) {
    const auto first = std::ranges::find(measured, false, &FrequencyPoint::limited);
    const auto last = std::ranges::find(first, measured.end(), true, &FrequencyPoint::limited);
    std::vector<FrequencyPoint> points;
    for (const FrequencyPoint& point : std::span(first, last)) {
        // T' = r T / (1 - T + r T), whose derivative by T is r / (1 - T + r T)^2.
        const Complex r = filterAt(to, point.hertz) / filterAt(from, point.hertz);
        const Complex below = 1.0 - point.closed + r * point.closed;
        points.push_back({point.hertz, r * point.closed / below, point.doubt * std::abs(r / (below * below)),
                          point.missed});
    }
    return points;
}

}  // namespace nmc
