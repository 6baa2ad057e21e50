// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace nmc {

/// Where a switch or the index changed, as the chip captured it, in counts (steps), once per approach.
struct EdgeCaptures {
    std::vector<std::int32_t> forward;  ///< counting up
    std::vector<std::int32_t> reverse;
    /// Counts that the motor moves between two readings of the inputs, at most.
    double perReading = 0.0;
    bool index = false;         ///< of the encoder, not a switch
    std::uint8_t readings = 1;  ///< most likely, while the motor moves by perReading

    bool operator==(const EdgeCaptures&) const = default;
};

/// How well the captures of one direction agree, in counts.
struct EdgeSpread {
    double mean = 0.0;       ///< less half a reading, by which a capture is late on average
    double deviation = 0.0;  ///< standard deviation
    double range = 0.0;      ///< from the lowest to the highest
};

struct Repeatability {
    EdgeSpread forward;
    EdgeSpread reverse;
    double backlash = 0.0;  ///< mean of forward minus mean of reverse, counts
    /// Counts to either side: what whole counts and the time between two readings leave open, plus the 95 %
    /// confidence of both means.
    double uncertainty = 0.0;
};

/// Empty before there are two captures in each direction. Pure.
[[nodiscard]] std::optional<Repeatability> repeatabilityOf(const EdgeCaptures& edges);

}  // namespace nmc
