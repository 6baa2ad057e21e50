// SPDX-License-Identifier: MIT
#include "bus/recheck.h"

#include <algorithm>

namespace nmc::bus {

bool Recheck::contains(BusAddress number) const {
    return std::ranges::find(m_numbers, number) != m_numbers.end();
}

void Recheck::begin() {
    m_left = m_numbers.size();
    m_found = false;
}

/// The last number comes first: if the answer to its Set Address is only late, it is noticed here.
std::optional<BusAddress> Recheck::next() const {
    return m_left > 0 ? std::optional(m_numbers[m_left - 1]) : std::nullopt;
}

void Recheck::noteInVain() {
    m_doubtful = false;
    ++m_inVain;
}

bool Recheck::onReply(const ReplyEnd& end) {
    --m_left;
    const bool there = !unanswered(end.result);
    if (there)
        m_numbers.erase(m_numbers.begin() + static_cast<std::ptrdiff_t>(m_left));
    m_found = m_found || there;
    m_doubtful = m_doubtful || (!there && !end.bytes.empty());
    return there;
}

}  // namespace nmc::bus
