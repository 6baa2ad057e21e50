// SPDX-License-Identifier: MIT
#pragma once

#include "sim/receiver.h"

namespace nmc::sim {

/// Takes the data bytes of a packet in their order, as far as the buffer goes.
class DataReader {
public:
    explicit DataReader(const Packet& packet) : m_data(packet.data) {}
    template <typename T>
    T next() {
        const T value = readLittleEndian<T>(m_data.subspan(m_at, sizeof(T)));
        m_at += sizeof(T);
        return value;
    }
    [[nodiscard]] std::size_t taken() const { return m_at; }

private:
    ByteSpan m_data;
    std::size_t m_at = 0;
};

}  // namespace nmc::sim
