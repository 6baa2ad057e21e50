// SPDX-License-Identifier: MIT
#include "model/scope/countrate.h"

namespace nmc {

std::optional<CountRate::Value> CountRate::take(const ScopeSample& sample) {
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
    const Value made{here.time, perSecond(m_readings.front()), m_gap};
    m_gap = false;
    return made;
}

}  // namespace nmc
