// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "base/strong.h"
#include "protocol/commandcode.h"

namespace nmc {

/// First byte of every command packet (DS-V 4.1).
inline constexpr std::uint8_t kHeader = 0xAA;
/// Maximum number of data bytes, as announced in the command byte.
inline constexpr std::size_t kMaxData = 15;
/// Header, address, command, data, checksum.
inline constexpr std::size_t kMaxPacket = kMaxData + 4;

using DataBytes = ByteBuffer<kMaxData>;
using PacketBytes = ByteBuffer<kMaxPacket>;

/// A command and its data bytes, regardless of the addressee.
struct Payload {
    CommandCode code = CommandCode::Nop;
    DataBytes data;

    /// Low nibble: command; high nibble: number of data bytes.
    [[nodiscard]] std::uint8_t commandByte() const;
    bool operator==(const Payload&) const = default;
};

/// A payload and its destination address: the contents of a command packet.
struct Frame {
    BusAddress address;
    Payload payload;
    bool operator==(const Frame&) const = default;
};

enum class FrameError : std::uint8_t { TooShort, NoHeader, LengthMismatch, Checksum };

/// Encodes a packet: `AA addr cmd data... sum`.
[[nodiscard]] PacketBytes toPacket(const Frame& frame);

/// Reads exactly one packet; the span must hold it and nothing else.
[[nodiscard]] tl::expected<Frame, FrameError> parsePacket(ByteSpan bytes);

}  // namespace nmc
