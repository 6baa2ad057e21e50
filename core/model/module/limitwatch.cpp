// SPDX-License-Identifier: MIT
#include "model/module/limitwatch.h"

namespace nmc {

void LimitWatch::apply(Limits closed, bool moves, Limits expected) {
    for (std::size_t i = 0; i < closed.size(); ++i) {
        const bool justClosed = m_seen && closed[i] && !m_closed[i];
        m_ranInto[i] = closed[i] && (m_ranInto[i] || (justClosed && moves && !expected[i]));
    }
    m_closed = closed;
    m_seen = true;
}

}  // namespace nmc
