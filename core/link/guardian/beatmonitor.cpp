// SPDX-License-Identifier: MIT
#include "link/guardian/beatmonitor.h"

namespace nmc {

std::optional<TimePoint> BeatMonitor::lookBy(const Beat& beat) const {
    if (!beat.moving)
        return std::nullopt;
    return m_stale == beat.at ? m_lookAgain : beat.at + kLongest;
}

bool BeatMonitor::expired(const Beat& beat, TimePoint now) {
    const auto by = lookBy(beat);
    if (!by || now < *by)
        return false;
    const bool seenBefore = m_stale == beat.at;
    const bool expiredBefore = seenBefore && m_expired;
    const bool tooLateToJudge = !seenBefore && now - *by > kLate;
    m_stale = beat.at;
    m_expired = !tooLateToJudge;
    m_lookAgain = now + kLongest;
    return m_expired && !expiredBefore;
}

}  // namespace nmc
