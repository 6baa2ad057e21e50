// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "base/bytes.h"
#include "protocol/commandcode.h"
#include "protocol/frame.h"

namespace nmc::sim {

/// A packet as the chip has it in its memory once the checksum byte is in.
struct Packet {
    std::uint8_t address = 0;
    std::uint8_t commandByte = 0;
    /// As on the chip nothing clears it: behind the bytes of this packet stand those of earlier ones, and a
    /// command that announces too few bytes is carried out with them.
    std::array<std::uint8_t, 16> data{};
    std::uint8_t sum = 0;
    bool framingError = false;
    bool struck = false;  ///< not as this host sent it: a fault has had a hand in it, or another host

    [[nodiscard]] CommandCode code() const { return static_cast<CommandCode>(commandByte & 0x0FU); }
    /// Number of data bytes that were received.
    [[nodiscard]] std::size_t length() const { return commandByte >> 4U; }
    [[nodiscard]] bool sumIsRight() const;
    /// The whole packet, header first, for the log.
    [[nodiscard]] PacketBytes bytes() const;
};

/// Finds packets in what a UART hears (DS-V 4.1): waits for AA, takes address, command byte, as many data
/// bytes as that announces, and the sum. It knows no time-out: after a lost byte the next packet becomes the
/// tail.
class Receiver {
public:
    /// True when `byte` completed a packet, which packet() then shows until the next header.
    bool hears(std::uint8_t byte, bool framingError, bool struck = false);
    [[nodiscard]] const Packet& packet() const { return m_packet; }
    /// True from a header on until its packet is complete.
    [[nodiscard]] bool inPacket() const { return m_expected != Expected::Header; }
    /// Forgets what has been received so far.
    void reset() { *this = Receiver{}; }

private:
    enum class Expected : std::uint8_t { Header, Address, Command, Data, Sum };

    Packet m_packet;
    Expected m_expected = Expected::Header;
    std::uint8_t m_received = 0;
};

}  // namespace nmc::sim
