// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/time.h"

namespace nmc::sim {

/// The current limit that CUR_LIM sets for the driver: the running limit in motion and for a while after it,
/// then the holding limit (DS-S 4.6).
class StepperCurrent {
public:
    void setLimits(std::uint8_t running, std::uint8_t holding) {
        m_running = running;
        m_holding = holding;
    }
    void motionSeen() { m_holdOver = kHoldOver; }
    void motorRests(Duration time) { m_holdOver = std::max(m_holdOver - time, Duration::zero()); }
    [[nodiscard]] std::uint8_t limit() const { return m_holdOver > Duration::zero() ? m_running : m_holding; }

private:
    static constexpr Duration kHoldOver = std::chrono::milliseconds(250);

    std::uint8_t m_running = 0;
    std::uint8_t m_holding = 0;
    Duration m_holdOver{};
};

}  // namespace nmc::sim
