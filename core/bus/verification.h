// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// A command for which it is unknown whether it was carried out, or which must not be repeated because of the
/// module's reply alone, and the query that decides (link.md 2.3).
struct Verification {
    ReplyEnd end;                          ///< the result instead of an answer
    std::optional<std::int32_t> position;  ///< before the command
    bool stood = true;                     ///< the motor, before the command
    unsigned attempts = 0;                 ///< number of retries after a verification
    unsigned looks = 0;
};

enum class Carried : std::uint8_t {
    Out,
    NotOut,   ///< provably not: it may be sent again
    Unknown,  ///< it is not retried; the user decides
};

/// The conclusion from a status that is newer than the command.
[[nodiscard]] Carried verify(const Order& order, const Belief& belief, const Verification& verification);

}  // namespace nmc::bus
