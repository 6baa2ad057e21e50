// SPDX-License-Identifier: MIT
#include "model/scope/countrate.h"

#include <utility>

namespace nmc {

std::optional<ScopeSample> CountRate::take(const ScopeSample& sample) {
    if (sample.gapBefore)
        m_readings.clear();
    m_gap = m_gap || sample.gapBefore;
    if (!sample.counted)
        return std::nullopt;
    const Reading here{sample.time, sample.counter()};
    const auto perSecond = [&here](const Reading& from) {
        // 32 bits that wrap: the difference of two counts is right across the wrap.
        return static_cast<double>(here.count - from.count) / toSeconds(here.time - from.time);
    };
    if (!m_readings.empty() && (here.time <= m_readings.back().time || perSecond(m_readings.back()) > kMax)) {
        m_readings.clear();
        m_gap = true;
    }
    m_readings.push_back(here);
    while (m_readings.size() > 2 && here.time - m_readings[1].time >= kTime)
        m_readings.pop_front();
    if (m_readings.size() < 2 || here.time - m_readings.front().time < kTime)
        return std::nullopt;
    const double rate = perSecond(m_readings.front());
    return derivedValue(here.time, rate, rate, rate, std::exchange(m_gap, false));
}

}  // namespace nmc
