// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/strong.h"
#include "base/time.h"

namespace nmc {

/// Counts that a servo at rest goes to and fro within its friction.
inline constexpr std::int32_t kStillCounts = 4;
/// No farther apart than a motor that stands still is from itself.
[[nodiscard]] constexpr bool samePlace(std::int32_t a, std::int32_t b) {
    const std::int64_t between = countsBetween(a, b);
    return between >= -kStillCounts && between <= kStillCounts;
}

/// That a motor stands still, for whoever must be sure: it says so, and its position has stayed for a while.
/// The bits alone do not tell: a servo that is off coasts, and a PIC-STEP's moving bit is not reliable behind
/// a smooth stop at home (protocol.md 3). Pure.
class Standstill {
public:
    static constexpr Duration kFor = std::chrono::milliseconds(60);

    void reset() { m_since.reset(); }
    /// Once per status; true from the look on that proves it.
    bool look(TimePoint time, std::int32_t position, bool moving) {
        if (moving || !m_since || !samePlace(m_position, position)) {
            m_since = time;
            m_position = position;
            m_looks = 0;
        } else if (time > m_last) {
            ++m_looks;
        }
        m_last = time;
        return !moving && m_looks >= 2 && time - *m_since >= kFor;
    }

private:
    std::optional<TimePoint> m_since;
    TimePoint m_last;
    std::int32_t m_position = 0;
    unsigned m_looks = 0;
};

}  // namespace nmc
