// SPDX-License-Identifier: MIT
#include "sim/path.h"

namespace nmc::sim {

namespace {

constexpr unsigned kReverse = 0x01;
constexpr unsigned kLonger = 0x02;  ///< F: the segment is twice as long

}  // namespace

bool Path::add(std::uint16_t word) {
    if (m_words.size() >= m_capacity)
        return false;
    m_words.push_back(word);
    return true;
}

void Path::end() {
    m_words.clear();
    m_ticksLeft = 0;
    m_running = false;
}

std::optional<std::int64_t> Path::next(bool fastPath) {
    if (m_ticksLeft == 0) {
        if (m_words.empty()) {
            end();
            return std::nullopt;
        }
        const unsigned word = m_words.front();
        m_words.pop_front();
        // Without its two low bits, the word is the speed in 1/256 count per tick.
        const std::int64_t speed = std::int64_t{word & ~(kReverse | kLonger)} * 256;
        m_velocity = (word & kReverse) != 0 ? -speed : speed;
        m_ticksLeft = ((word & kLonger) != 0 ? 64 : 32) / (fastPath ? 2 : 1);
    }
    --m_ticksLeft;
    return m_velocity;
}

}  // namespace nmc::sim
