// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace nmc {

/// Which limit switches have closed while the motor moved, or were closed and ended a motion, until they open
/// again. One that the chip was told to watch for (HomeWatch) was to be found, and is not meant here. Part of
/// ModuleState. Pure.
class LimitWatch {
public:
    using Limits = std::array<bool, 2>;  ///< limit 1, limit 2

    struct Reading {
        Limits closed{};
        bool moves = false;  ///< at this status or at the one before
        bool ended = false;  ///< one of them has just ended a motion
        Limits expected{};   ///< the chip watched for it until now
    };
    /// Of each status.
    void apply(const Reading& reading);

    /// Limit 1 is 0.
    [[nodiscard]] bool ranInto(std::size_t limit) const { return m_ranInto.at(limit); }

private:
    bool m_seen = false;  ///< some status
    Limits m_closed{};
    Limits m_ranInto{};
};

}  // namespace nmc
