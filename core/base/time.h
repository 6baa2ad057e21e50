// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <optional>

namespace nmc {

/// The time base of bus and simulator. It has no now(): the transport (or a test) takes the time stamps and
/// passes them in, so that everything in core also runs in virtual time.
struct BusClock {
    using rep = std::int64_t;
    using period = std::nano;
    using duration = std::chrono::nanoseconds;
    using time_point = std::chrono::time_point<BusClock>;
    static constexpr bool is_steady = true;
};

using Duration = BusClock::duration;
using TimePoint = BusClock::time_point;

/// The earliest of these times; empty if there is none.
[[nodiscard]] constexpr std::optional<TimePoint> earliest(
    std::initializer_list<std::optional<TimePoint>> times) {
    std::optional<TimePoint> first;
    for (const std::optional<TimePoint>& time : times)
        if (time && (!first || *time < *first))
            first = *time;
    return first;
}

/// One servo tick at 20 MHz: 1953.125 ticks per second (DS-V 3.1).
inline constexpr Duration kServoTick = std::chrono::microseconds(512);

[[nodiscard]] constexpr double toSeconds(Duration d) {
    return static_cast<double>(d.count()) * 1e-9;
}
/// The length of a servo tick in seconds at servo rate SR, which multiplies it (DS-V 4.3); 0 counts as 1.
[[nodiscard]] constexpr double secondsPerTick(int servoRate) {
    return toSeconds(kServoTick) * (servoRate < 1 ? 1 : servoRate);
}
[[nodiscard]] constexpr double ticksPerSecond(int servoRate) {
    return 1.0 / secondsPerTick(servoRate);
}
[[nodiscard]] constexpr Duration fromSeconds(double s) {
    return Duration(static_cast<Duration::rep>(s * 1e9 + (s < 0 ? -0.5 : 0.5)));
}

}  // namespace nmc
