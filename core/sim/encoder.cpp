// SPDX-License-Identifier: MIT
#include "sim/encoder.h"

#include <algorithm>

namespace nmc::sim {

void Encoder::read(std::int64_t shaft) {
    const std::int64_t edges = std::clamp(shaft - m_shaft, -m_maxEdges, m_maxEdges);
    m_shaft = shaft;
    m_counter = static_cast<std::uint16_t>(m_counter + (m_reversed ? -edges : edges));
    const auto moved = static_cast<std::int16_t>(static_cast<std::uint16_t>(m_counter - m_lastRead));
    m_lastRead = m_counter;
    const std::int64_t next = std::int64_t{m_position} + moved;
    m_position = static_cast<std::int32_t>(next);
    m_wrapped = m_wrapped || next != m_position;
}

void Encoder::setPosition(std::int32_t position) {
    m_position = position;
    m_counter = static_cast<std::uint16_t>(position);
    m_lastRead = m_counter;
}

}  // namespace nmc::sim
