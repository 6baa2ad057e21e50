// SPDX-License-Identifier: MIT
#include "model/module/measuredspeed.h"

#include <cstdlib>

#include "base/strong.h"
#include "module/commandfacts.h"

namespace nmc {

namespace {
using namespace std::chrono_literals;
constexpr Duration kAnchored = 100ms;
constexpr Duration kShortestSpan = 50ms;
/// After a silence, the distance covered in between is not a speed.
constexpr Duration kTooLongAgo = 1s;
}  // namespace

void MeasuredSpeed::apply(TimePoint time, std::int32_t position) {
    if (m_latest && (time <= m_latest->time || time - m_latest->time > kTooLongAgo))
        forget();
    m_latest = Reading{time, position};
    if (!m_anchor) {
        m_anchor = m_latest;
    } else if (time - m_anchor->time >= kAnchored) {
        m_before = m_anchor;
        m_anchor = m_latest;
    }
}

void MeasuredSpeed::apply(const bus::CommandExecuted& executed) {
    if (setsCounter(executed.command))
        forget();
}

std::optional<double> MeasuredSpeed::perSecond() const {
    const auto& from = m_before ? m_before : m_anchor;
    if (!from || m_latest->time - from->time < kShortestSpan)
        return std::nullopt;
    const std::int32_t distance = countsBetween(from->position, m_latest->position);
    // A shaft held between two counts alternates between the two.
    if (std::abs(std::int64_t{distance}) <= 1)
        return 0.0;
    return distance / toSeconds(m_latest->time - from->time);
}

}  // namespace nmc
