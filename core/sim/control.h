// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "base/time.h"
#include "sim/chain.h"

namespace nmc::sim {

/// Answers one control line (simulator.md, Control) with one line of JSON, without its line end:
/// `state N`, `set N NAME VALUE`, `power-cycle N|all`, `break N`, `mend N`, `stats`, `time`. Modules count
/// from 1. Anything else gets `{"error":...}`, which names what is allowed, and changes nothing.
/// `lagSeconds`: how far the simulation is behind the clock it is paced by; only `time` reports it.
[[nodiscard]] std::string handleControlLine(Chain& chain, std::string_view line, TimePoint now,
                                            double lagSeconds = 0.0);

}  // namespace nmc::sim
