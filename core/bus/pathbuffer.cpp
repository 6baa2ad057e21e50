// SPDX-License-Identifier: MIT
#include "bus/pathbuffer.h"

#include <algorithm>

namespace nmc::bus {

namespace {

/// Number of points that leave the buffer in this time, at least.
[[nodiscard]] std::size_t whole(Duration time, Duration period) {
    return time > Duration{} ? static_cast<std::size_t>(time / period) : 0;
}

}  // namespace

std::size_t PathBuffer::frame() const {
    const std::size_t rest = m_points - m_sent;
    const bool two = rest > kLongestFrame && rest < kLongestFrame + kShortestFrame;
    return two ? kShortestFrame : std::min(rest, kLongestFrame);
}

TimePoint PathBuffer::roomAt() const {
    const std::size_t full = m_sent + frame();
    if (full <= m_capacity + m_taken)
        return TimePoint::min();
    const auto missing = static_cast<Duration::rep>(full - m_capacity - m_taken);
    return m_running ? m_by + kServoTick + missing * m_period : TimePoint::max();
}

void PathBuffer::start(TimePoint latched) {
    m_running = true;
    m_from = m_by = latched;
}

void PathBuffer::onReported(std::size_t left, TimePoint from, TimePoint by) {
    m_taken = m_sent - std::min(left, m_sent);
    m_from = from;
    m_by = by;
}

std::size_t PathBuffer::taken(TimePoint now) const {
    const std::size_t since = m_running ? whole(now - m_by - kServoTick, m_period) : 0;
    return std::min(m_taken + since, m_sent);
}

/// Between two reports, a point leaves at each whole period, and one more depending on the phase.
PathBuffer::Range PathBuffer::left(std::size_t sent, TimePoint from, TimePoint by) const {
    if (!m_running)
        return {sent - m_taken, sent - m_taken};
    const std::size_t fewest = m_taken + whole(from - m_by - kServoTick, m_period);
    const std::size_t most = m_taken + whole(by - m_from + kServoTick, m_period) + 1;
    return {sent - std::min(most, sent), sent - std::min(fewest, sent)};
}

std::optional<bool> PathBuffer::carriedOut(std::size_t doubtful, std::size_t reported, TimePoint from,
                                           TimePoint by) const {
    const bool without = left(m_sent, from, by).has(reported);
    const bool with = left(m_sent + doubtful, from, by).has(reported);
    return without == with ? std::nullopt : std::optional(with);
}

TimePoint PathBuffer::dryAt() const {
    const auto left = static_cast<Duration::rep>(m_sent - std::min(m_taken, m_sent));
    return m_running ? m_from + left * m_period : TimePoint::max();
}

}  // namespace nmc::bus
