// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/pathpoint.h"

namespace nmc::test {

/// The point that a word of Add Path Points stands for; nothing when a bit is set that must be zero at the
/// point's rate.
[[nodiscard]] inline std::optional<servo::PathPoint> fromPathWord(std::uint16_t word, bool fastPath) {
    using servo::PathRate;
    const bool longer = (word & 2U) != 0;
    const PathRate rate = longer == fastPath ? PathRate::Hz60 : longer ? PathRate::Hz30 : PathRate::Hz120;
    const unsigned scale = 256U / static_cast<unsigned>(ticksPerPoint(rate));
    const unsigned speed = word & ~3U;
    if (speed % scale != 0)
        return std::nullopt;
    const auto counts = static_cast<std::int32_t>(speed / scale);
    return servo::PathPoint{(word & 1U) != 0 ? -counts : counts, rate};
}

}  // namespace nmc::test
