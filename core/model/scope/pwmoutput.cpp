// SPDX-License-Identifier: MIT
#include "model/scope/pwmoutput.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/time.h"

namespace nmc {

namespace {

/// Counts. The error is the difference of two whole numbers, so its change in a tick may be off by this much
/// from the whole number next to its average change.
constexpr double kRounding = 1.0;

constexpr unsigned kOvercurrent = 0x04;  ///< status byte, sticky (DS-V 5.3)
constexpr unsigned kServoOn = 0x04;      ///< auxiliary byte

double sumLimit(const servo::SetGain& gains) {
    return 256.0 * gains.il;
}

double toAmplifier(const servo::SetGain& gains, double output) {
    double magnitude = std::min(std::trunc(std::abs(output) / 256), static_cast<double>(gains.ol));
    if (magnitude > 0)
        magnitude = std::min(magnitude + gains.db.value_or(0), 255.0);
    return output < 0 ? -magnitude : magnitude;
}

}  // namespace

std::optional<ScopeSample> PwmOutput::take(const ScopeSample& sample,
                                           const std::optional<servo::SetGain>& gains) {
    if (!gains || !sample.errorKnown() || (sample.aux & kServoOn) == 0) {
        const auto made = finished({});
        m_last.reset();
        m_gap = true;
        return made;
    }
    if (m_last && !sample.gapBefore && sample.time > m_last->sample.time) {
        const double ticks = toSeconds(sample.time - m_last->sample.time) / secondsPerTick(gains->sr);
        const Change change{
            (static_cast<double>(sample.error) - static_cast<double>(m_last->sample.error)) / ticks,
            sample.error == m_last->sample.error && sample.position == m_last->sample.position};
        const auto made = finished(change);
        m_last = Known{sample, *gains, advanced(*m_last, sample, ticks), change};
        return made;
    }
    const auto made = finished({});
    m_gap = true;
    m_last = Known{sample, *gains, {-sumLimit(*gains), 0, sumLimit(*gains)}};
    return made;
}

/// The error is taken to run along a straight line from one sample to the next.
PwmOutput::Range PwmOutput::advanced(const Known& before, const ScopeSample& to, double ticks) {
    const double limit = sumLimit(before.gains);
    const auto add = [&](double sum, float first, float second) {
        const double mean = (static_cast<double>(first) + static_cast<double>(second)) / 2;
        return std::clamp(sum + ticks * mean, -limit, limit);
    };
    return {add(before.sum.low, before.sample.errorLow, to.errorLow),
            add(before.sum.likely, before.sample.error, to.error),
            add(before.sum.high, before.sample.errorHigh, to.errorHigh)};
}

std::optional<ScopeSample> PwmOutput::finished(std::optional<Change> changeAfter) {
    if (!m_last || !(m_last->changeBefore || changeAfter))
        return std::nullopt;
    const ScopeSample& sample = m_last->sample;
    const servo::SetGain& gains = m_last->gains;
    const Change either = changeAfter ? *changeAfter : *m_last->changeBefore;
    const double before = m_last->changeBefore.value_or(either).perTick;
    const double after = either.perTick;
    const bool still = m_last->changeBefore.value_or(either).none && either.none;
    const double rounding = still ? 0.0 : kRounding;
    const double least = std::floor(std::min(before, after)) - rounding;
    const double most = std::ceil(std::max(before, after)) + rounding;
    const auto output = [&](double error, double change, double sum) {
        return toAmplifier(gains, gains.kp * error + gains.kd * change + gains.ki * std::trunc(sum / 256));
    };
    const double likely = output(static_cast<double>(sample.error), (before + after) / 2, m_last->sum.likely);
    double low = output(std::floor(static_cast<double>(sample.errorLow)), least, m_last->sum.low);
    double high = output(static_cast<double>(sample.errorHigh), most, m_last->sum.high);
    if (gains.cl != 0 && (sample.status & kOvercurrent) != 0) {
        low = std::min(low, 0.0);
        high = std::max(high, 0.0);
    }
    return derivedValue(sample.time, likely, low, high, std::exchange(m_gap, false));
}

}  // namespace nmc
