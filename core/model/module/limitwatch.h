// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace nmc {

/// Tracks which limit switches closed while the motor moved, or were closed and ended a motion, until they
/// open again. A switch that the chip was set to watch for (HomeWatch) was meant to be found and does not
/// count. Part of ModuleState. Pure.
class LimitWatch {
public:
    using Limits = std::array<bool, 2>;  ///< limit 1, limit 2

    struct Reading {
        Limits closed{};
        bool moves = false;  ///< in this status or the previous one
        bool ended = false;  ///< a limit switch has just ended a motion
        Limits expected{};   ///< the chip was watching for the switch until now
    };
    /// Call for each status.
    void apply(const Reading& reading);

    /// `limit` is 0 for limit 1.
    [[nodiscard]] bool ranInto(std::size_t limit) const { return m_ranInto.at(limit); }

private:
    bool m_seen = false;  ///< a status has been seen
    Limits m_closed{};
    Limits m_ranInto{};
};

}  // namespace nmc
