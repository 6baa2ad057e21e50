// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"

namespace nmc {

/// Counts the ticks of one module. Whatever it latches, it latches in a tick (DS-V 4.1), and ticks are
/// kServoTick apart: a window shorter than that determines the tick, and all windows together determine the
/// relation of this machine's clock to the module's. The number of ticks between two commands is therefore
/// known exactly, although the moment of neither is. Pure.
class TickClock {
public:
    /// The maximum relative drift between the module's clock and this machine's: two crystals of 50 ppm.
    static constexpr double kApart = 100e-6;

    /// The bounds of a moment.
    struct Window {
        TimePoint earliest;
        TimePoint latest;
    };

    /// Reports that something was latched in this window, in the order of the module's ticks. `resting`:
    /// nothing depends on ticks counted before, so counting may begin here or restart. Counting ends with a
    /// window that can contain no tick.
    void learn(const Window& latched, bool resting);

    [[nodiscard]] bool counts() const { return m_tick.has_value(); }
    /// The first and the last tick that may have latched something in a window, by the module's clock.
    /// Returns nothing while ticks are not being counted.
    [[nodiscard]] std::optional<Window> ticksIn(const Window& latched) const;

private:
    /// A tick that was counted.
    struct Tick {
        Window here;      ///< its time by this machine's clock
        TimePoint there;  ///< its time by the module's clock
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
