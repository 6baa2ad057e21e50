// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"

namespace nmc {

/// How fast a shaft turns, from where it was 0.1 to 0.2 s before: what the chip itself says is whole counts
/// per tick, 0 up to 1950 counts/s. Pure.
class MeasuredSpeed {
public:
    /// Of status replies, as they come.
    void apply(TimePoint time, std::int32_t position);
    /// A counter that was set is no motion.
    void apply(const bus::CommandExecuted& executed);
    void forget() { *this = {}; }

    /// Counts (steps) a second. Empty: it was not looked at for long enough.
    [[nodiscard]] std::optional<double> perSecond() const;

private:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
    };
    std::optional<Reading> m_latest;
    std::optional<Reading> m_anchor;  ///< at most 0.1 s before the latest
    std::optional<Reading> m_before;  ///< the anchor before that
};

}  // namespace nmc
