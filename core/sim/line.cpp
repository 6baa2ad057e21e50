// SPDX-License-Identifier: MIT
#include "sim/line.h"

#include <algorithm>
#include <cmath>

namespace nmc::sim {

void HostLine::send(ByteSpan bytes, TimePoint now, bool foreign) {
    m_freeAt = std::max(m_freeAt, now);
    for (const std::uint8_t value : bytes) {
        if (m_bytes.size() == kCapacity) {
            ++m_lost;
            continue;
        }
        m_freeAt += byteTimeAtBaud(m_baud);
        m_bytes.push_back({m_freeAt, m_baud, value, foreign});
    }
}

std::optional<TimePoint> HostLine::nextDue() const {
    if (m_bytes.empty())
        return std::nullopt;
    return m_bytes.front().due;
}

LineByte HostLine::take() {
    const LineByte byte = m_bytes.front();
    m_bytes.pop_front();
    return byte;
}

PacketBytes HostLine::packetBehind(std::uint8_t header) const {
    PacketBytes packet{header};
    for (const LineByte& byte : m_bytes) {
        if (packet.size() > kCommandByteAt && packet.size() == packetLength(packet[kCommandByteAt]))
            break;
        packet.push_back(byte.value);
    }
    return packet;
}

// An SC's clock is twice as fast; the nearest rate to its nominal 230 400 Bd is one eleventh of 2 500 000.
double uartRate(const ModuleIdentity& module, std::uint8_t brd) {
    return isSc(module) && brd == kScFastestBrd ? 2'500'000.0 / 11 : realRate(brd);
}

double garbleProbability(double rate, std::uint32_t baud, double margin) {
    const double mismatch = std::abs(baud / rate - 1.0);
    return std::clamp((mismatch - margin) / kSampling, 0.0, 1.0);
}

std::uint8_t garbled(std::uint8_t value, Random& random) {
    return static_cast<std::uint8_t>(value ^ (1U + random.below(255)));
}

}  // namespace nmc::sim
