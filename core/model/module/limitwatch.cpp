// SPDX-License-Identifier: MIT
#include "model/module/limitwatch.h"

namespace nmc {

void LimitWatch::apply(const Look& look) {
    for (std::size_t i = 0; i < look.closed.size(); ++i) {
        const bool justClosed = m_seen && !m_closed[i];
        const bool met = (justClosed && look.moves) || look.ended;
        m_ranInto[i] = look.closed[i] && (m_ranInto[i] || (met && !look.expected[i]));
    }
    m_closed = look.closed;
    m_seen = true;
}

}  // namespace nmc
