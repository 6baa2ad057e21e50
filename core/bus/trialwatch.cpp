// SPDX-License-Identifier: MIT
#include "bus/trialwatch.h"

#include <algorithm>
#include <cmath>

#include "base/strong.h"

namespace nmc::bus {

namespace {

/// Counts to either side that are not a swing: encoder and friction.
constexpr double kStill = 1.5;
/// Amplitude from which a half cycle counts: samples miss the peaks of a swing by 8, and a well-tuned servo
/// that creeps by a few counts, because of friction and Ki, does not cross from side to side.
constexpr double kGate = 6.0;
constexpr int kHalfCycles = 3;  ///< consecutive
constexpr Duration kWindow = std::chrono::seconds(1);
/// Ratio to the previous half cycle: a smaller swing dies down by itself, with a zeta above 0.05.
constexpr double kStays = 0.85;

}  // namespace

std::optional<TrialEnd> TrialWatch::look(TimePoint time, std::int32_t position) {
    const auto off = static_cast<double>(countsBetween(m_trial.stood, position));
    const double far = std::abs(off);
    if (far * m_tried.kp > 256.0 * m_tried.ol)
        return TrialEnd::Saturates;
    if (far > m_trial.reach)
        return TrialEnd::TooFar;
    if (far <= kStill)
        return std::nullopt;
    if (m_halfCycles.empty() || m_halfCycles.back().ahead != (off > 0)) {
        std::erase_if(m_halfCycles, [&](const HalfCycle& old) { return time - old.last > kWindow; });
        m_halfCycles.push_back({off > 0, time, 0.0});
    }
    m_halfCycles.back().last = time;
    m_halfCycles.back().peak = std::max(m_halfCycles.back().peak, far);
    return swings(time) ? std::optional(TrialEnd::Swings) : std::nullopt;
}

bool TrialWatch::swings(TimePoint now) const {
    int inARow = 0;
    double before = 0.0;
    for (const HalfCycle& one : m_halfCycles) {
        const bool counts = one.peak >= kGate && now - one.last <= kWindow;
        inARow = !counts ? 0 : one.peak >= kStays * before ? inARow + 1 : 1;
        before = one.peak;
    }
    return inARow >= kHalfCycles;
}

}  // namespace nmc::bus
