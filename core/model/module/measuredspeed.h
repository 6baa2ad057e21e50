// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"

namespace nmc {

/// Measures the speed of a shaft from its position 0.1 to 0.2 s before: the chip itself reports whole counts
/// per tick, which is 0 up to 1950 counts/s. Pure.
class MeasuredSpeed {
public:
    /// Call for each status reply, in order.
    void apply(TimePoint time, std::int32_t position);
    /// Discards the readings after a command that sets the counter, because the jump is not a motion.
    void apply(const bus::CommandExecuted& executed);
    void forget() { *this = {}; }

    /// Counts (steps) per second. Empty: the readings do not span enough time.
    [[nodiscard]] std::optional<double> perSecond() const;

private:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
    };
    std::optional<Reading> m_latest;
    std::optional<Reading> m_anchor;  ///< at most 0.1 s older than the latest
    std::optional<Reading> m_before;  ///< the previous anchor
};

}  // namespace nmc
