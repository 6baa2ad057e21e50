// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "protocol/commandcode.h"
#include "protocol/frame.h"

namespace nmc::sim {

/// A packet as it is in the chip's memory once the checksum byte has arrived.
struct Packet {
    std::uint8_t address = 0;
    std::uint8_t commandByte = 0;
    /// Nothing clears it, as on the chip: the bytes of earlier packets remain after those of this one, and a
    /// command that announces too few bytes is executed with them.
    std::array<std::uint8_t, 16> data{};
    std::uint8_t sum = 0;
    bool framingError = false;
    bool struck = false;  ///< not as this host sent it, because of a fault or another host

    [[nodiscard]] CommandCode code() const { return static_cast<CommandCode>(commandByte & 0x0FU); }
    /// Number of data bytes received.
    [[nodiscard]] std::size_t length() const { return commandByte >> 4U; }
    [[nodiscard]] bool sumIsRight() const;
    /// The whole packet, header first, for the log.
    [[nodiscard]] PacketBytes bytes() const;
};

/// Finds packets in the bytes that a UART receives (DS-V 4.1): waits for AA, then takes address, command
/// byte, the number of data bytes announced there, and the sum. It has no time-out: after a lost byte, the
/// start of the next packet is taken for the missing end.
class Receiver {
public:
    /// Returns true when `byte` completed a packet, which packet() returns until the next header.
    bool hears(std::uint8_t byte, bool framingError, bool struck = false);
    [[nodiscard]] const Packet& packet() const { return m_packet; }
    /// True from a header until its packet is complete.
    [[nodiscard]] bool inPacket() const { return m_expected != Expected::Header; }

private:
    enum class Expected : std::uint8_t { Header, Address, Command, Data, Sum };

    Packet m_packet;
    Expected m_expected = Expected::Header;
    std::uint8_t m_received = 0;
};

}  // namespace nmc::sim
