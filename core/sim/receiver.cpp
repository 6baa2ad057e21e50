// SPDX-License-Identifier: MIT
#include "sim/receiver.h"

namespace nmc::sim {

bool Packet::sumIsRight() const {
    const unsigned wanted = 0U + address + commandByte + sum8(ByteSpan(data).first(length()));
    return (wanted & 0xFFU) == sum;
}

PacketBytes Packet::bytes() const {
    PacketBytes all{kHeader, address, commandByte};
    all.append(ByteSpan(data).first(length()));
    all.push_back(sum);
    return all;
}

bool Receiver::hears(std::uint8_t byte, bool framingError, bool struck) {
    const bool begins = m_expected == Expected::Header;
    m_packet.framingError = framingError || (m_packet.framingError && !begins);
    m_packet.struck = struck || (m_packet.struck && !begins);
    switch (m_expected) {
        case Expected::Header:
            if (byte == kHeader)
                m_expected = Expected::Address;
            break;
        case Expected::Address:
            m_packet.address = byte;
            m_expected = Expected::Command;
            break;
        case Expected::Command:
            m_packet.commandByte = byte;
            m_received = 0;
            m_expected = m_packet.length() > 0 ? Expected::Data : Expected::Sum;
            break;
        case Expected::Data:
            m_packet.data[m_received++] = byte;
            if (m_received == m_packet.length())
                m_expected = Expected::Sum;
            break;
        case Expected::Sum:
            m_packet.sum = byte;
            m_expected = Expected::Header;
            return true;
    }
    return false;
}

}  // namespace nmc::sim
