// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scope/history.h"

namespace nmc {

/// Detects when a shaft began to move, from its positions alone, so that it works for every type of module
/// and any cause of motion. A motion begins with the last sample at the place where the shaft stood, and ends
/// when the shaft has stood for kRest. Pure.
class MotionStart {
public:
    static constexpr Duration kRest = std::chrono::milliseconds(200);
    /// Samples per call: a millisecond or two of work.
    static constexpr std::uint64_t kAtOnce = 50'000;

    /// Processes the new samples, always of the same module. Returns false when there are more, for another
    /// call.
    bool follow(const ModuleHistory& history);
    [[nodiscard]] std::optional<TimePoint> first() const { return m_first; }
    [[nodiscard]] std::optional<TimePoint> last() const { return m_last; }

private:
    void take(const ScopeSample& sample);

    std::uint64_t m_count = 0;           ///< samples processed so far
    std::optional<ScopeSample> m_place;  ///< where the shaft stands, or was last seen to have moved on to
    TimePoint m_lastThere;               ///< time of the last sample at that place
    bool m_moves = false;
    std::optional<TimePoint> m_first, m_last;
};

}  // namespace nmc
