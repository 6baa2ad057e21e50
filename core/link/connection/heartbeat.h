// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>

#include "base/time.h"

namespace nmc {

/// Checks that the GUI thread still runs its event loop: a frozen panel cannot accept a stop, so the bus
/// thread then stops the motors itself (link.md 2.7). It has no clock of its own, and is lock-free between
/// the two threads.
class Heartbeat {
public:
    static constexpr Duration kInterval = std::chrono::milliseconds(100);  ///< interval of beat()
    static constexpr Duration kNoted = std::chrono::seconds(1);            ///< longer gaps are reported
    static constexpr Duration kStopAfter = std::chrono::seconds(2);        ///< while a motor moves
    /// The panel shows a chain once this many beats have followed it without a gap worth reporting.
    static constexpr int kShown = 10;

    /// A period during which the panel was frozen.
    struct Gap {
        Duration length{};
        bool stopped = false;  ///< missed() has returned true during the gap
    };

    /// Begins a connection. Beats are expected once the panel shows a chain, or has commanded something:
    /// motors that were left running are not stopped because a window opens slowly. Call while the bus thread
    /// does not run.
    void begin() {
        m_beatsToShow.reset();
        m_expected = false;
        m_stopped = false;
    }
    /// The panel has a chain to show. GUI thread.
    void found() { m_beatsToShow = kShown; }
    /// The panel commands something. GUI thread.
    void commanded(TimePoint now) {
        if (m_expected)
            return;
        m_last = now.time_since_epoch().count();
        m_expected = true;
    }
    /// Reports that the GUI thread is alive; returns the preceding gap if it is worth reporting. GUI thread.
    [[nodiscard]] std::optional<Gap> beat(TimePoint now) {
        const Gap gap{now - last(), m_stopped.exchange(false)};
        m_last = now.time_since_epoch().count();
        const bool noted = gap.stopped || gap.length > kNoted;
        if (m_expected)
            return noted ? std::optional(gap) : std::nullopt;
        if (m_beatsToShow) {
            m_beatsToShow = noted ? kShown : *m_beatsToShow - 1;
            m_expected = *m_beatsToShow == 0;
        }
        return std::nullopt;
    }
    /// True when the motors must be stopped: no beat for kStopAfter while something moves. Once per gap. Bus
    /// thread.
    [[nodiscard]] bool missed(TimePoint now, bool moving) {
        return moving && m_expected && now - last() >= kStopAfter && !m_stopped.exchange(true);
    }
    /// The latest time at which missed() must be called again. Bus thread.
    [[nodiscard]] std::optional<TimePoint> deadline(bool moving) const {
        return moving && m_expected && !m_stopped ? std::optional(last() + kStopAfter) : std::nullopt;
    }

private:
    [[nodiscard]] TimePoint last() const { return TimePoint(Duration(m_last.load())); }

    std::atomic<Duration::rep> m_last{0};
    std::atomic<bool> m_expected{false};
    std::atomic<bool> m_stopped{false};
    std::optional<int> m_beatsToShow;  ///< GUI thread
};

}  // namespace nmc
