// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace nmc::sim {

/// The path buffer of PIC-SERVO CMC and SC (docs/family.md, Path points): words of Add Path Points, each a
/// speed for a fixed number of servo ticks. The nominal 30, 60 and 120 Hz are in fact 64, 32 and 16 ticks, so
/// that every segment ends exactly on its point.
class Path {
public:
    /// The number of points that version 5 (CMC) and version 10 (SC) can hold.
    [[nodiscard]] static constexpr std::size_t capacityOf(std::uint8_t version) {
        return version >= 10 ? 128 : version >= 5 ? 96 : 0;
    }
    explicit Path(std::size_t capacity) : m_capacity(capacity) {}

    /// Returns false when the buffer is full and the point is lost.
    bool add(std::uint16_t word);
    void start() { m_running = true; }
    /// Ends the path and discards the remaining points.
    void end();
    [[nodiscard]] bool running() const { return m_running; }
    /// Points in the buffer; the point being executed is no longer in it.
    [[nodiscard]] std::size_t points() const { return m_words.size(); }

    /// Returns the velocity of the next servo tick in 1/65536 count per tick, or nothing when the buffer has
    /// run empty, which ends the path. `fastPath`: 60 and 120 Hz instead of 30 and 60.
    std::optional<std::int64_t> next(bool fastPath);

private:
    std::deque<std::uint16_t> m_words;
    std::size_t m_capacity;
    std::int64_t m_velocity = 0;
    int m_ticksLeft = 0;  ///< ticks left of the current segment
    bool m_running = false;
};

}  // namespace nmc::sim
