// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"

namespace nmc {

/// Counts the ticks of one module. Whatever it latches it latches in a tick (DS-V 4.1), and ticks are
/// kServoTick apart: a window that is shorter tells which tick it was, and all windows together how this
/// machine's clock stands to the module's. So how many ticks lie between two commands is known exactly,
/// though the moment of neither is. Pure.
class TickClock {
public:
    /// How far the module's clock and this machine's may run apart: two crystals of 50 ppm.
    static constexpr double kApart = 100e-6;

    /// From when to when something was, at the outside.
    struct Window {
        TimePoint earliest;
        TimePoint latest;
    };

    /// Something was latched in this window; in the order of the module's ticks. `resting`: nothing depends
    /// on ticks that were counted before, so counting may begin here, or anew. It ends with a window in which
    /// no tick can be.
    void learn(const Window& latched, bool resting);

    [[nodiscard]] bool counts() const { return m_tick.has_value(); }
    /// The first and the last tick that may have latched something in a window, by the module's clock.
    /// Nothing while none are counted.
    [[nodiscard]] std::optional<Window> ticksIn(const Window& latched) const;

private:
    /// One that was counted.
    struct Tick {
        Window here;      ///< when it was, by this machine's clock
        TimePoint there;  ///< and by the module's
    };
    struct Range {
        std::int64_t first = 0;
        std::int64_t last = 0;
    };
    [[nodiscard]] Window at(TimePoint time) const;
    [[nodiscard]] Range behind(const Window& latched) const;

    std::optional<Tick> m_tick;
};

}  // namespace nmc
