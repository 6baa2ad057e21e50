// SPDX-License-Identifier: MIT
#include "model/scope/standingerror.h"

#include <algorithm>
#include <cmath>

namespace nmc {

namespace {

double halfBand(const CommandEstimate& command) {
    return (command.high - command.low) / 2;
}

}  // namespace

void StandingError::leave(const CommandEstimate& command) {
    // After a rest that was too short, the uncertainty is carried over to the next motion.
    if (m_reported)
        m_before = halfBand(command);
    m_reported = false;
    m_still.reset();
}

std::optional<CommandEstimate> StandingError::look(TimePoint time, std::int32_t position, bool moving,
                                                   const CommandEstimate& command) {
    if (m_reported || !m_still.look(time, position, moving))
        return std::nullopt;
    m_reported = true;
    const double low = command.low - position;
    const double high = command.high - position;
    const double reach = std::max(std::abs(low), std::abs(high));
    const double own = std::max(0.0, halfBand(command) - m_before);
    const double farthest = std::max(m_farthest.value_or(0.0), own);
    // A deviation farther than ever before is genuine. And rests about which more was known say nothing about
    // a rest after a motion that could not be followed.
    const bool usual = m_farthest && own <= 2 * m_own && std::abs(command.position - position) <= farthest;
    m_own = std::max(m_own, own);
    if (command.low == command.high || !usual) {
        m_added = 0;
        m_farthest = std::max(m_farthest.value_or(0.0), reach);
        return std::nullopt;
    }
    m_added += own;
    // No more is taken back than the motions since then have added: load and friction may have changed.
    const double cutLow = std::max(0.0, -farthest - low);
    const double cutHigh = std::max(0.0, high - farthest);
    const double cut = cutLow + cutHigh;
    const double share = cut > 2 * m_added ? 2 * m_added / cut : 1.0;
    m_added -= share * cut / 2;
    const CommandEstimate narrower{0, command.low + share * cutLow, command.high - share * cutHigh};
    return CommandEstimate{(narrower.low + narrower.high) / 2, narrower.low, narrower.high};
}

}  // namespace nmc
