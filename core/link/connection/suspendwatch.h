// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "base/time.h"

namespace nmc {

/// Detects that the machine was suspended. Neither the monotonic clock nor a timer shows it, because both
/// stood still. Pure; one thread.
class SuspendWatch {
public:
    /// Two clocks read one after the other differ by microseconds; after a suspension they differ by seconds.
    static constexpr Duration kShortest = std::chrono::milliseconds(500);

    /// `asleep`: the total time that the machine has been suspended since boot. Returns the length of the
    /// latest suspension, once.
    [[nodiscard]] std::optional<Duration> check(Duration asleep) {
        const Duration just = asleep - m_asleep.value_or(asleep);
        if (!m_asleep || just >= kShortest)
            m_asleep = asleep;
        return just >= kShortest ? std::optional(just) : std::nullopt;
    }

private:
    std::optional<Duration> m_asleep;
};

}  // namespace nmc
