// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>

#include "base/time.h"

namespace nmc {

/// That a motor stands still, for whoever must be sure: it says so, and its position has stayed for a while.
/// The bits alone do not tell: a servo that is off coasts, and a PIC-STEP's moving bit is not reliable behind
/// a smooth stop at home (protocol.md 3). Pure.
class Standstill {
public:
    /// Counts: a servo works within its friction.
    static constexpr std::int64_t kStill = 4;
    static constexpr Duration kFor = std::chrono::milliseconds(60);

    void reset() { m_since.reset(); }
    /// Once per status; true from the look on that proves it.
    bool look(TimePoint time, std::int32_t position, bool moving) {
        if (moving || !m_since || std::abs(std::int64_t{position} - m_position) > kStill) {
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
    std::int64_t m_position = 0;
    unsigned m_looks = 0;
};

}  // namespace nmc
