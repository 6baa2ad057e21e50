// SPDX-License-Identifier: MIT
#include "model/scope/tickclock.h"

#include <algorithm>
#include <ratio>

namespace nmc {

namespace {

/// Less frequent reports are not worth counting by, because the clocks drift apart in the meantime.
constexpr Duration kCountsFor = std::chrono::milliseconds(50);

[[nodiscard]] TimePoint middle(const TickClock::Window& window) {
    return window.earliest + (window.latest - window.earliest) / 2;
}

using Ticks = std::chrono::duration<std::int64_t, std::ratio<512, 1'000'000>>;
static_assert(Ticks(1) == kServoTick);

}  // namespace

void TickClock::learn(const Window& latched, bool resting) {
    if (m_tick && resting) {
        m_tick->there = middle(m_tick->here);
        if (latched.latest - m_tick->here.latest > kCountsFor)
            m_tick.reset();
    }
    if (!m_tick) {
        if (resting && latched.latest - latched.earliest < kServoTick)
            m_tick = {latched, middle(latched)};
        return;
    }
    const auto [first, last] = behind(latched);
    if (first > last) {
        m_tick.reset();  // a clock was set, or a time was wrong
    } else if (first == last) {
        const Window here = at(latched.latest);
        const Duration ticks = first * kServoTick;
        m_tick->here = {std::max(here.earliest + ticks, latched.earliest),
                        std::min(here.latest + ticks, latched.latest)};
        m_tick->there += ticks;
    }
}

std::optional<TickClock::Window> TickClock::ticksIn(const Window& latched) const {
    if (!m_tick)
        return std::nullopt;
    const auto [first, last] = behind(latched);
    if (first > last)
        return std::nullopt;
    return Window{m_tick->there + first * kServoTick, m_tick->there + last * kServoTick};
}

/// The known tick by this machine's clock, with the uncertainty that applies at `time`.
TickClock::Window TickClock::at(TimePoint time) const {
    const Duration apart =
        std::chrono::duration_cast<Duration>(kApart * std::chrono::abs(time - m_tick->here.earliest));
    return {m_tick->here.earliest - apart, m_tick->here.latest + apart};
}

/// The number of ticks after the known tick.
TickClock::Range TickClock::behind(const Window& latched) const {
    const Window here = at(latched.latest);
    return {std::chrono::ceil<Ticks>(latched.earliest - here.latest).count(),
            std::chrono::floor<Ticks>(latched.latest - here.earliest).count()};
}

}  // namespace nmc
