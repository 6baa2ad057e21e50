// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "protocol/frame.h"
#include "sim/fault.h"
#include "sim/random.h"

namespace nmc::sim {

/// What happens to each byte of one frame in transit.
struct FrameEdit {
    struct Byte {
        std::uint8_t copies = 1;
        std::uint8_t flips = 0;  ///< the bits that are wrong
        bool error = false;      ///< the receiver detects an error
    };
    std::array<Byte, kMaxPacket> at;

    [[nodiscard]] std::vector<std::uint8_t> applied(ByteSpan frame) const;
};

/// A frame, as far as it is known when it is struck.
struct FrameInSight {
    ByteSpan bytes;          ///< the first bytes; all of them when the sender handed them over at once
    std::size_t length = 0;  ///< length of the whole frame
    std::size_t first = 0;   ///< index of the first byte that has not been received yet
    bool isPacket = false;   ///< a command packet; Collide leaves its header and its length alone
};

/// Damage of one of the first seven kinds, or nothing when this frame cannot be damaged in that way.
[[nodiscard]] std::optional<FrameEdit> makeEdit(FaultKind kind, const FrameInSight& frame,
                                                std::optional<unsigned> bit, Random& random);

}  // namespace nmc::sim
