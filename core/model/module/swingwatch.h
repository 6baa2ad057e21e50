// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.h"

namespace nmc {

/// A servo that should hold and swings (too much Kp or Ki, or too little Kd: DS-V 4.3), as its positions of
/// the last second tell; or hunts, as its turns of the last ones do. Pure.
class SwingWatch {
public:
    struct Swing {
        double amplitude = 0.0;  ///< counts to either side
        std::optional<double>
            hertz{};  ///< empty: it is looked at too rarely for that, or swings at no one rate
        /// Slowly, by a few counts: what the integral gathers breaks friction, again and again.
        bool hunts = false;
        bool operator==(const Swing&) const = default;
    };

    /// So long after a motion was commanded what it leaves behind has calmed down, or does not.
    static constexpr Duration kCalm = std::chrono::milliseconds(500);

    /// While the servo is to hold one position.
    void look(TimePoint time, std::int32_t position);
    /// It is off, moves, or is told something else.
    void forget();
    /// Kept as it was for a while: it is looked into a few times a second.
    [[nodiscard]] const std::optional<Swing>& swing() const { return m_swing; }

private:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
    };
    [[nodiscard]] std::optional<Swing> lookInto() const;
    void watchTurns(const Reading& reading);
    [[nodiscard]] std::optional<Swing> hunting(TimePoint now) const;

    std::vector<Reading> m_turns;  ///< where it was farthest before it turned round, oldest first
    std::optional<Reading> m_farthest;
    bool m_forward = false;           ///< how it went there
    std::vector<Reading> m_readings;  ///< oldest first; a vector, since states are copied, and most hold none
    std::optional<Swing> m_swing;
    TimePoint m_lookedInto{};
};

}  // namespace nmc
