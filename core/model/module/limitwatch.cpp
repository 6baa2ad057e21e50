// SPDX-License-Identifier: MIT
#include "model/module/limitwatch.h"

namespace nmc {

void LimitWatch::apply(const Reading& reading) {
    for (std::size_t i = 0; i < reading.closed.size(); ++i) {
        const bool justClosed = m_seen && !m_closed[i];
        const bool met = (justClosed && reading.moves) || reading.ended;
        m_ranInto[i] = reading.closed[i] && (m_ranInto[i] || (met && !reading.expected[i]));
    }
    m_closed = reading.closed;
    m_seen = true;
}

}  // namespace nmc
