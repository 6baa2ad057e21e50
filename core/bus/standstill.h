// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/strong.h"
#include "base/time.h"
#include "protocol/status.h"

namespace nmc {

/// Counts by which a servo at rest moves to and fro within its friction.
inline constexpr std::int32_t kStillCounts = 4;
/// True if two positions are within standstill tolerance.
[[nodiscard]] constexpr bool samePlace(std::int32_t a, std::int32_t b) {
    const std::int64_t between = countsBetween(a, b);
    return between >= -kStillCounts && between <= kStillCounts;
}

/// True if the report of a module shows motion, or a servo's does not contain its velocity.
[[nodiscard]] inline bool showsMotion(ModuleType type, const StatusReport& report) {
    if (type == ModuleType::Stepper)
        return report.stepperStatus().moving();
    return type == ModuleType::Servo &&
           (!report.servoStatus().moveDone() || report.velocity.value_or(1) != 0);
}

/// Proves that a motor stands still, where certainty is required: it reports so, and its position has stayed
/// the same for a while. The bits alone are not enough: a servo that is off coasts, and the moving bit of a
/// PIC-STEP is not reliable after a smooth stop at home (protocol.md 3). Pure.
class Standstill {
public:
    static constexpr Duration kFor = std::chrono::milliseconds(60);

    void reset() { m_since.reset(); }
    /// Call once per status; returns true from the call on that proves standstill.
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
