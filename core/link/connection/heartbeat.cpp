// SPDX-License-Identifier: MIT
#include "link/connection/heartbeat.h"

namespace nmc {

void Heartbeat::begin(TimePoint now) {
    m_last = now.time_since_epoch().count();
    m_stopped = false;
}

std::optional<Heartbeat::Gap> Heartbeat::beat(TimePoint now) {
    const Gap gap{now - last(), m_stopped.exchange(false)};
    m_last = now.time_since_epoch().count();
    return gap.stopped || gap.length > kNoted ? std::optional(gap) : std::nullopt;
}

bool Heartbeat::missed(TimePoint now, bool moving) {
    return moving && now - last() >= kStopAfter && !m_stopped.exchange(true);
}

std::optional<TimePoint> Heartbeat::deadline(bool moving) const {
    return moving && !m_stopped ? std::optional(last() + kStopAfter) : std::nullopt;
}

}  // namespace nmc
