// SPDX-License-Identifier: MIT
#include "model/scope/measuredacceleration.h"

#include <utility>

namespace nmc {

std::optional<ScopeSample> MeasuredAcceleration::take(const ScopeSample& sample) {
    if (sample.gapBefore)
        m_places.clear();
    m_gap = m_gap || sample.gapBefore;
    m_places.push_back({sample.time, static_cast<double>(sample.position)});
    while (m_places.size() > kFewest && sample.time - m_places[1].time >= kTime)
        m_places.pop_front();
    const Duration time = sample.time - m_places.front().time;
    if (m_places.size() < kFewest || time < kTime)
        return std::nullopt;
    const TimePoint middle = m_places.front().time + time / 2;
    const double value = fitted(middle);
    return derivedValue(middle, value, value, value, std::exchange(m_gap, false));
}

/// Fits y = a + b t + c t^2 by least squares, for c. Times are relative to their mean, so that the sum of t
/// is 0 and the normal equations can be solved by hand.
double MeasuredAcceleration::fitted(TimePoint middle) const {
    const auto count = static_cast<double>(m_places.size());
    double mean = 0;
    for (const Place& place : m_places)
        mean += toSeconds(place.time - middle) / count;
    double t2 = 0, t3 = 0, t4 = 0, y = 0, ty = 0, t2y = 0;
    for (const Place& place : m_places) {
        const double t = toSeconds(place.time - middle) - mean;
        const double far = place.position - m_places.front().position;
        t2 += t * t;
        t3 += t * t * t;
        t4 += t * t * t * t;
        y += far;
        ty += t * far;
        t2y += t * t * far;
    }
    const double square = (t2y - t2 / count * y - t3 / t2 * ty) / (t4 - t2 * t2 / count - t3 * t3 / t2);
    return 2 * square;
}

}  // namespace nmc
