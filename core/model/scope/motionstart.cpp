// SPDX-License-Identifier: MIT
#include "model/scope/motionstart.h"

#include "base/strong.h"

namespace nmc {

namespace {

constexpr std::int32_t kSamePlace = 4;  ///< counts: smaller changes are noise or a holding servo, not motion

}  // namespace

bool MotionStart::follow(const ModuleHistory& history) {
    m_count = history.visitSince(
        m_count, [this](const ScopeSample& sample) { take(sample); }, kAtOnce);
    return m_count >= history.count();
}

void MotionStart::take(const ScopeSample& sample) {
    // At rest, a jump over a gap is a counter that was set, or a motion whose start was not seen.
    if (!m_place || (sample.gapBefore && !m_moves)) {
        m_place = sample;
        m_lastThere = sample.time;
        return;
    }
    const std::int32_t away = countsBetween(m_place->position, sample.position);
    if (away >= -kSamePlace && away <= kSamePlace) {
        m_moves = m_moves && sample.time - m_place->time < kRest;
        m_lastThere = sample.time;
        return;
    }
    if (!m_moves) {
        m_last = m_lastThere;
        if (!m_first)
            m_first = m_last;
    }
    m_moves = true;
    m_place = sample;
    m_lastThere = sample.time;
}

}  // namespace nmc
