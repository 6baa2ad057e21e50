// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/time.h"

namespace nmc {

/// What the panel's bus loop says of itself each time it turns.
struct Beat {
    TimePoint at;  ///< of the monotonic clock, which stands still while the machine is suspended
    bool moving = false;
    bool operator==(const Beat&) const = default;
};

/// Whether a panel that still exists has left its motors alone. Without a clock; one thread.
///
/// A beat that is too old has one of two causes: the loop is stuck, or this machine lets nobody have his
/// turn. Whoever judges is his own measure of that: a judge who comes late himself lets one more period pass
/// before he believes what he sees.
class BeatJudge {
public:
    /// The oldest that a beat may be while anything moves.
    static constexpr Duration kLongest = std::chrono::milliseconds(150);
    /// From here on a look is late.
    static constexpr Duration kLate = std::chrono::milliseconds(20);

    /// When to call expired() again, at the latest; nothing while nothing moves.
    [[nodiscard]] std::optional<TimePoint> lookBy(const Beat& beat) const;
    /// The motors must be stopped. Once a beat: it takes a new one before this says so again.
    [[nodiscard]] bool expired(const Beat& beat, TimePoint now);

private:
    std::optional<TimePoint> m_stale;  ///< the beat that was last found too old
    bool m_said = false;               ///< and said to be
    TimePoint m_lookAgain;             ///< at that one
};

}  // namespace nmc
