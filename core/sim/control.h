// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/time.h"
#include "sim/chain.h"

namespace nmc::sim {

/// What the code that paces the chain knows and `time` reports; `stats` also reports the stalls.
struct Pace {
    double lagSeconds = 0.0;      ///< the largest delay of a byte behind its due time since the last query
    double lateP99Seconds = 0.0;  ///< delay not exceeded by 99 of 100 bytes to the host, since the last query
    std::uint64_t received = 0;   ///< bytes taken from the host so far
    std::uint64_t sent = 0;       ///< bytes given to the host so far
    std::uint64_t stalls = 0;     ///< times that the pacer was not scheduled for more than 20 ms
    double longestStallSeconds = 0.0;
};

/// Answers one control line (simulator.md, Control) with one line of JSON, without its line end: `state N`,
/// `set N NAME VALUE`, `power-cycle N|all`, `break N`, `mend N`, `fault ...`, `fault clear`, `faults`,
/// `foreign BYTES`, `stats`, `stats clear`, `time`, `help`. Modules count from 1. Any other line is answered
/// with `{"error":...}`, which names what is allowed, and changes nothing. Without `pace`, answers say
/// nothing about it.
[[nodiscard]] std::string handleControlLine(Chain& chain, std::string_view line, TimePoint now,
                                            const std::optional<Pace>& pace = {});

/// A text for users: all control lines, what `set` can change with its polarity and range, and the kinds of
/// violations.
[[nodiscard]] std::string controlHelp();

}  // namespace nmc::sim
