// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/time.h"

namespace nmc {

/// Notices that the machine was suspended. Neither the monotonic clock nor a timer tells: both stood still.
/// Pure; one thread.
class SuspendWatch {
public:
    /// Reading two clocks one after the other differs by microseconds; a suspended machine by seconds.
    static constexpr Duration kShortest = std::chrono::milliseconds(500);

    /// `asleep`: all the time the machine has been suspended since it was started. How long it has just been
    /// suspended, told once.
    [[nodiscard]] std::optional<Duration> check(Duration asleep) {
        const Duration just = m_asleep ? asleep - *m_asleep : Duration{};
        if (m_asleep && just < kShortest)
            return std::nullopt;
        const bool first = !m_asleep;
        m_asleep = asleep;
        return first ? std::nullopt : std::optional(just);
    }

private:
    std::optional<Duration> m_asleep;
};

}  // namespace nmc
