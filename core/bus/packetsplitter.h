// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "protocol/frame.h"

namespace nmc::bus {

/// Splits what another host sends into packets, as the modules do (DS-V 4.1): what comes before a header is
/// skipped, and a packet that has begun waits for its rest, however long that takes. The sum is not checked.
class PacketSplitter {
public:
    /// Returns true when this byte completes a packet.
    bool take(std::uint8_t byte) {
        if (!incomplete() && byte != kHeader) {
            m_skipped.push_back(byte);
            return false;
        }
        if (!incomplete())
            m_packet.clear();
        m_packet.push_back(byte);
        // Header, address, command, data, sum.
        constexpr std::size_t kCommand = 2;
        m_whole = m_packet.size() > kCommand && m_packet.size() == (m_packet[kCommand] >> 4U) + 4U;
        return m_whole;
    }
    /// A packet has begun, and is not complete.
    [[nodiscard]] bool incomplete() const { return !m_whole; }
    /// The last complete packet.
    [[nodiscard]] const PacketBytes& packet() const { return m_packet; }
    /// The bytes outside of packets since the last call.
    [[nodiscard]] std::vector<std::uint8_t> takeSkipped() { return std::exchange(m_skipped, {}); }

private:
    PacketBytes m_packet;
    bool m_whole = true;
    std::vector<std::uint8_t> m_skipped;
};

}  // namespace nmc::bus
