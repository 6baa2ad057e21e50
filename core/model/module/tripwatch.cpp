// SPDX-License-Identifier: MIT
#include "model/module/tripwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bus/standstill.h"

namespace nmc {

namespace {

/// With motor or encoder reversed, the loop amplifies the first count of error, so the trip follows at once.
constexpr Duration kAtOnce = std::chrono::seconds(1);
/// Fractions of the error limit, and of the speed, below this reciprocal are negligible.
constexpr int kPart = 10;

[[nodiscard]] bool ranAwayFromHold(const TripFacts& f, std::int64_t little) {
    if (!f.enabled || f.since > kAtOnce || std::abs(f.moved) < f.errorLimit / 2)
        return false;
    // A motor that swings to both sides is unstable, which gains can cause as well.
    return std::min(f.farthest, -f.rearmost) <= little;
}

}  // namespace

TripCause diagnose(const TripFacts& f) {
    const std::int64_t little = std::max(kStillCounts, f.errorLimit / kPart);
    const std::int64_t along = f.moved * f.direction;
    if (ranAwayFromHold(f, little) || along < -little)
        return TripCause::Reversed;
    if (f.limit1Closed || f.limit2Closed)
        return f.limit1Closed ? TripCause::Limit1 : TripCause::Limit2;
    if (f.direction == 0)
        return TripCause::Unknown;
    return along <= little || f.speed * kPart <= f.velocity ? TripCause::Jam : TripCause::Behind;
}

void TripWatch::apply(const Command& command) {
    m_command = command;
    m_first = m_last;
    m_farthest = m_rearmost = 0;
}

void TripWatch::apply(const Reading& reading) {
    m_last = reading;
    if (!m_first)
        m_first = reading;
    const std::int64_t moved = countsBetween(m_first->position, reading.position);
    m_farthest = std::max(m_farthest, moved);
    m_rearmost = std::min(m_rearmost, moved);
}

std::optional<TripFacts> TripWatch::facts(const Reading& off, std::int32_t errorLimit) const {
    if (!m_command || !m_first || !m_last)
        return std::nullopt;
    TripFacts f;
    f.errorLimit = errorLimit;
    f.enabled = m_command->fromOff && m_command->direction == 0;
    f.direction = m_command->fromRest ? m_command->direction : 0;
    f.velocity = m_command->velocity;
    f.since = off.time - m_command->time;
    f.moved = countsBetween(m_first->position, off.position);
    f.farthest = std::max(m_farthest, f.moved);
    f.rearmost = std::min(m_rearmost, f.moved);
    if (off.time > m_last->time)
        f.speed = std::abs(static_cast<double>(countsBetween(m_last->position, off.position))) /
                  toSeconds(off.time - m_last->time);
    f.limit1Closed = off.limit1 && !m_first->limit1;
    f.limit2Closed = off.limit2 && !m_first->limit2;
    return f;
}

}  // namespace nmc
