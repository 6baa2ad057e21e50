// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/time.h"

namespace nmc {

/// The panel's bus loop reports this each time it runs.
struct Beat {
    TimePoint at;  ///< monotonic clock, which stands still while the machine is suspended
    bool moving = false;
    bool operator==(const Beat&) const = default;
};

/// Decides whether a panel that still exists has abandoned its motors. It has no clock of its own; one
/// thread.
///
/// A beat that is too old has one of two causes: the loop hangs, or the machine does not schedule any
/// process. The observer's own delay distinguishes the two: an observer that is itself late waits for one
/// more period before it trusts what it sees.
class BeatMonitor {
public:
    /// The maximum age of a beat while anything moves.
    static constexpr Duration kLongest = std::chrono::milliseconds(150);
    /// A check later than this counts as late.
    static constexpr Duration kLate = std::chrono::milliseconds(20);

    /// The latest time at which expired() must be called again; nothing while nothing moves.
    [[nodiscard]] std::optional<TimePoint> lookBy(const Beat& beat) const {
        if (!beat.moving)
            return std::nullopt;
        return m_stale == beat.at ? m_lookAgain : beat.at + kLongest;
    }
    /// Returns true when the motors must be stopped, once per beat: it returns true again only after a new
    /// beat.
    [[nodiscard]] bool expired(const Beat& beat, TimePoint now) {
        const auto by = lookBy(beat);
        if (!by || now < *by)
            return false;
        const bool seenBefore = m_stale == beat.at;
        const bool expiredBefore = seenBefore && m_expired;
        const bool tooLateToJudge = !seenBefore && now - *by > kLate;
        m_stale = beat.at;
        m_expired = !tooLateToJudge;
        m_lookAgain = now + kLongest;
        return m_expired && !expiredBefore;
    }

private:
    std::optional<TimePoint> m_stale;  ///< the beat last found too old
    bool m_expired = false;            ///< expired() has returned true for it
    TimePoint m_lookAgain;             ///< time of the next check of that beat
};

}  // namespace nmc
