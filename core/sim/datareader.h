// SPDX-License-Identifier: MIT
#pragma once

#include "sim/receiver.h"

namespace nmc::sim {

/// Reads the data bytes of a packet in order.
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

/// Positions range from -7FFFFFFF to 7FFFFFFF, and a goal may be no farther than that from the motor's
/// position (DS-V 5.2, DS-S 5.1: Load Trajectory).
[[nodiscard]] constexpr bool isGoal(std::int32_t goal, std::int32_t position) {
    constexpr std::int64_t kFarthest = 0x7FFF'FFFF;
    const std::int64_t distance = std::int64_t{goal} - position;
    return goal >= -kFarthest && distance >= -kFarthest && distance <= kFarthest;
}

}  // namespace nmc::sim
