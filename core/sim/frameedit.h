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

/// What becomes of each byte of one frame on its way.
struct FrameEdit {
    struct Byte {
        std::uint8_t copies = 1;
        std::uint8_t flips = 0;  ///< the bits that are wrong
        bool error = false;      ///< the receiver notices
    };
    std::array<Byte, kMaxPacket> at;

    [[nodiscard]] std::vector<std::uint8_t> applied(ByteSpan frame) const;
};

/// A frame as far as it is known when it is struck.
struct FrameInSight {
    ByteSpan bytes;          ///< the first ones; all of them when the sender handed them over at once
    std::size_t length = 0;  ///< of the whole
    std::size_t first = 0;   ///< the first one that has not been heard yet
    bool isPacket = false;   ///< a command packet: its header and its length are left alone by Collide
};

/// Damage of one of the first seven kinds, or nothing when it cannot be done to this frame.
[[nodiscard]] std::optional<FrameEdit> makeEdit(FaultKind kind, const FrameInSight& frame,
                                                std::optional<unsigned> bit, Random& random);

}  // namespace nmc::sim
