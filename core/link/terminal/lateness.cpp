// SPDX-License-Identifier: MIT
#include "link/terminal/lateness.h"

#include <algorithm>
#include <cstdio>

namespace nmc {

void Lateness::add(Duration late) {
    const auto step = static_cast<std::size_t>(std::max(late, Duration::zero()) / kStep);
    ++m_steps[std::min(step, m_steps.size() - 1)];
    ++m_count;
    m_largest = std::max(m_largest, late);
}

Duration Lateness::percentile99() const {
    const std::uint64_t enough = m_count - m_count / 100;
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < m_steps.size() && m_count > 0; ++i) {
        seen += m_steps[i];
        if (seen >= enough)
            return i + 1 < m_steps.size() ? kStep * static_cast<std::int64_t>(i + 1) : m_largest;
    }
    return {};
}

void StallWatch::runs(TimePoint now) {
    const Duration pause = now - m_last.value_or(now);
    m_last = now;
    if (pause <= kStall)
        return;
    ++m_count;
    m_longest = std::max(m_longest, pause);
}

std::optional<std::string> LagReport::sentence(Duration behind, TimePoint now) {
    constexpr Duration kWorthSaying = std::chrono::milliseconds(10);
    constexpr Duration kEvery = std::chrono::seconds(5);
    if (behind == Duration::zero() && m_isBehind) {
        m_isBehind = false;
        return "caught up with real time.";
    }
    if (behind <= kWorthSaying || (m_said && now - *m_said < kEvery))
        return std::nullopt;
    m_isBehind = true;
    m_said = now;
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.2f s behind real time; use fewer modules or a lower --speed.",
                  toSeconds(behind));
    return text.data();
}

}  // namespace nmc
