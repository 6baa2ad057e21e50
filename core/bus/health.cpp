// SPDX-License-Identifier: MIT
#include "bus/health.h"

#include <algorithm>

namespace nmc::bus {

void Health::add(bool wrong, int change) {
    m_window.set(m_next, wrong);
    m_next = (m_next + 1) % kWindow;
    m_seen = std::min(m_seen + 1, kWindow);
    m_bucket = std::max(m_bucket + change, 0);
    if (m_level == LinkHealth::Lost || m_bucket >= kLost)
        m_level = LinkHealth::Lost;
    else if (m_bucket >= kMarginal)
        m_level = LinkHealth::Marginal;
    else if (m_bucket == 0)
        m_level = LinkHealth::Good;  // not already below 30: the level would fluctuate
}

}  // namespace nmc::bus
