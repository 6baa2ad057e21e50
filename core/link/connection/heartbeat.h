// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>

#include "base/time.h"

namespace nmc {

/// Whether the GUI thread still turns its event loop: a panel that is frozen cannot be told to stop, so the
/// bus thread does it by itself (link.md 2.7). Without a clock; lock-free between the two threads.
class Heartbeat {
public:
    static constexpr Duration kInterval = std::chrono::milliseconds(100);  ///< of beat()
    static constexpr Duration kNoted = std::chrono::seconds(1);            ///< longer gaps are told
    static constexpr Duration kStopAfter = std::chrono::seconds(2);        ///< while something moves

    /// The panel was frozen and is back.
    struct Gap {
        Duration length{};
        bool stopped = false;  ///< missed() said so meanwhile
    };

    /// From now on beats are expected. While the bus thread does not run.
    void begin(TimePoint now);
    /// The GUI thread lives. Tells of the gap before, when it was worth it. GUI thread.
    [[nodiscard]] std::optional<Gap> beat(TimePoint now);
    /// The motors must be stopped: no beat for kStopAfter while something moves. Once a gap. Bus thread.
    [[nodiscard]] bool missed(TimePoint now, bool moving);
    /// When to ask missed() again, at the latest. Bus thread.
    [[nodiscard]] std::optional<TimePoint> deadline(bool moving) const;

private:
    [[nodiscard]] TimePoint last() const { return TimePoint(Duration(m_last.load())); }

    std::atomic<Duration::rep> m_last{0};
    std::atomic<bool> m_stopped{false};
};

}  // namespace nmc
