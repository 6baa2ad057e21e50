// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/time.h"
#include "sim/chain.h"

namespace nmc::sim {

/// What whoever paces the chain knows and `time` reports; `stats` has the stalls as well.
struct Pace {
    double lagSeconds = 0.0;      ///< the largest delay of a byte behind its due time since last asked
    double lateP99Seconds = 0.0;  ///< within which 99 of 100 bytes were given to the host, since last asked
    std::uint64_t received = 0;   ///< bytes taken from the host so far
    std::uint64_t sent = 0;       ///< bytes given to the host so far
    std::uint64_t stalls = 0;     ///< times that the pacer was not let run for more than 20 ms
    double longestStallSeconds = 0.0;
};

/// Answers one control line (simulator.md, Control) with one line of JSON, without its line end:
/// `state N`, `set N NAME VALUE`, `power-cycle N|all`, `break N`, `mend N`, `fault ...`, `fault clear`,
/// `faults`, `foreign BYTES`, `stats`, `stats clear`, `time`, `help`. Modules count from 1. Anything else
/// gets
/// `{"error":...}`, which names what is allowed, and changes nothing.
[[nodiscard]] std::string handleControlLine(Chain& chain, std::string_view line, TimePoint now,
                                            const Pace& pace = {});

/// All control lines, what `set` knows with its polarity and range, and the kinds of violations, to be read.
[[nodiscard]] std::string controlHelp();

}  // namespace nmc::sim
