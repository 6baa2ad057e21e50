// SPDX-License-Identifier: MIT
#include "protocol/frame.h"

namespace nmc {

std::uint8_t Payload::commandByte() const {
    return static_cast<std::uint8_t>(data.size() << 4U | static_cast<std::uint8_t>(code));
}

PacketBytes toPacket(const Frame& frame) {
    PacketBytes bytes{kHeader, frame.address.value(), frame.payload.commandByte()};
    bytes.append(frame.payload.data);
    bytes.push_back(sum8(ByteSpan(bytes).subspan(1)));
    return bytes;
}

tl::expected<Frame, FrameError> parsePacket(ByteSpan bytes) {
    if (bytes.size() < 4)
        return tl::unexpected(FrameError::TooShort);
    if (bytes[0] != kHeader)
        return tl::unexpected(FrameError::NoHeader);
    const std::size_t dataSize = bytes[2] >> 4U;
    if (bytes.size() != dataSize + 4)
        return tl::unexpected(FrameError::LengthMismatch);
    if (sum8(bytes.subspan(1, dataSize + 2)) != bytes.back())
        return tl::unexpected(FrameError::Checksum);
    return Frame{BusAddress(bytes[1]),
                 Payload{static_cast<CommandCode>(bytes[2] & 0xFU), DataBytes(bytes.subspan(3, dataSize))}};
}

}  // namespace nmc
