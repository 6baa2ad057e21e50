// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// A command that was sent and of which it is not known whether it was carried out, or that must not be
/// repeated on the module's word alone, and the look that tells (link.md 2.3).
struct Verification {
    ReplyEnd end;                          ///< what came instead of an answer
    std::optional<std::int32_t> position;  ///< before the command
    unsigned attempts = 0;                 ///< how often it has been repeated after a look
    unsigned looks = 0;
};

enum class Carried : std::uint8_t {
    Out,
    NotOut,   ///< provably: it may be sent again
    Unknown,  ///< it is not repeated; the operator decides
};

/// What a status that is newer than the command says about it.
[[nodiscard]] Carried verify(const Order& order, const Belief& belief, const Verification& verification);

}  // namespace nmc::bus
