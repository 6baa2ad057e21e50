// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.h"

namespace nmc {

/// Detects a servo that should hold but swings (too much Kp or Ki, or too little Kd: DS-V 4.3), from its
/// positions in the last second, or hunts, from its last turns. Pure.
class SwingWatch {
public:
    struct Swing {
        double amplitude = 0.0;         ///< counts to either side
        std::optional<double> hertz{};  ///< empty: polled too rarely, or no single frequency
        /// Swings slowly, by a few counts: the accumulated integral breaks static friction again and again.
        bool hunts = false;
    };

    /// Time after a motion command by which its aftereffects have settled, if they settle at all.
    static constexpr Duration kCalm = std::chrono::milliseconds(500);

    /// Call while the servo should hold one position.
    void look(TimePoint time, std::int32_t position);
    /// Call when the servo is off, moves, or is sent another command.
    void forget();
    /// Evaluated only a few times a second, and unchanged in between.
    [[nodiscard]] const std::optional<Swing>& swing() const { return m_swing; }

private:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
    };
    [[nodiscard]] std::optional<Swing> lookInto() const;
    void watchTurns(const Reading& reading);
    [[nodiscard]] std::optional<Swing> hunting(TimePoint now) const;

    std::vector<Reading> m_turns;  ///< extreme positions at which the motion reversed, oldest first
    std::optional<Reading> m_farthest;
    bool m_forward = false;           ///< direction towards m_farthest
    std::vector<Reading> m_readings;  ///< oldest first; a vector, since states are copied, and most hold none
    std::optional<Swing> m_swing;
    TimePoint m_lookedInto{};
};

}  // namespace nmc
