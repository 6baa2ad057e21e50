// SPDX-License-Identifier: MIT
#include "model/scope/countrate.h"

namespace nmc {

std::optional<CountRate::Value> CountRate::take(const ScopeSample& sample) {
    if (sample.gapBefore)
        m_looks.clear();
    m_gap = m_gap || sample.gapBefore;
    if (!sample.counted)
        return std::nullopt;
    const Look here{sample.time, sample.counter()};
    const auto perSecond = [&here](const Look& from) {
        // 32 bits that wrap: the difference of two is right across the wrap.
        return static_cast<double>(here.count - from.count) / toSeconds(here.time - from.time);
    };
    if (!m_looks.empty() && (here.time <= m_looks.back().time || perSecond(m_looks.back()) > kMax)) {
        m_looks.clear();
        m_gap = true;
    }
    m_looks.push_back(here);
    while (m_looks.size() > 2 && here.time - m_looks[1].time >= kTime)
        m_looks.pop_front();
    if (m_looks.size() < 2 || here.time - m_looks.front().time < kTime)
        return std::nullopt;
    const Value made{here.time, perSecond(m_looks.front()), m_gap};
    m_gap = false;
    return made;
}

}  // namespace nmc
