// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

/// Points of Add Path Points, PIC-SERVO CMC and SC (docs/family.md, Path points).
namespace nmc::servo {

/// Nominal rates: a segment takes a whole number of servo ticks, so the real rates are 30.5, 61.0 and 122.1
/// Hz.
enum class PathRate : std::uint8_t { Hz30, Hz60, Hz120 };

/// Servo ticks from one point to the next.
[[nodiscard]] constexpr int ticksPerPoint(PathRate rate) {
    switch (rate) {
        case PathRate::Hz30:
            return 64;
        case PathRate::Hz60:
            return 32;
        case PathRate::Hz120:
            return 16;
    }
    return 0;
}

/// The nominal rate: 30, 60 or 120.
[[nodiscard]] constexpr int nominalHertz(PathRate rate) {
    return 1920 / ticksPerPoint(rate);
}

/// The longest segment in counts, in either direction: the magnitude has 14, 13 or 12 bits.
[[nodiscard]] constexpr std::int32_t maxPathCounts(PathRate rate) {
    return 256 * ticksPerPoint(rate) - 1;
}

/// One segment of a path: a number of counts covered at constant speed.
struct PathPoint {
    std::int32_t counts = 0;
    PathRate rate = PathRate::Hz60;
    bool operator==(const PathPoint&) const = default;
};

/// Returns the word as sent: bit 0 reverse, bit 1 F, above them the magnitude, left-justified. F set means 30
/// Hz, or 60 Hz with fast path; F clear means 60 Hz, or 120 Hz with fast path. Without those two bits the
/// word is the speed in 1/256 count per tick. Returns nothing when the rate is not available with this fast
/// path setting, or the segment is too long.
[[nodiscard]] std::optional<std::uint16_t> toPathWord(const PathPoint& point, bool fastPath);

}  // namespace nmc::servo
