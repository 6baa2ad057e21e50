// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scope/history.h"

namespace nmc {

/// When a shaft began to move, from its positions alone: it holds for every type of module and whatever
/// moved it. A motion begins with the last sample at the place where the shaft stood, and is over when the
/// shaft has stood for kRest. Pure.
class MotionStart {
public:
    static constexpr Duration kRest = std::chrono::milliseconds(200);
    /// Samples of one call: a millisecond or two of work.
    static constexpr std::uint64_t kAtOnce = 50'000;

    /// Takes what has come, always of the same module. False: there is more of it, for another call.
    bool follow(const ModuleHistory& history);
    [[nodiscard]] std::optional<TimePoint> first() const { return m_first; }
    [[nodiscard]] std::optional<TimePoint> last() const { return m_last; }

private:
    void take(const ScopeSample& sample);

    std::uint64_t m_count = 0;           ///< samples that were taken
    std::optional<ScopeSample> m_place;  ///< where the shaft stands, or was last seen to have moved on
    TimePoint m_lastThere;               ///< the last sample at that place
    bool m_moves = false;
    std::optional<TimePoint> m_first, m_last;
};

}  // namespace nmc
