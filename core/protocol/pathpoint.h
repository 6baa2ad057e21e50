// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

/// Points of Add Path Points, PIC-SERVO CMC and SC (docs/family.md, Path points).
namespace nmc::servo {

/// Nominal: a segment takes a whole number of servo ticks, so it is 30.5, 61.0 and 122.1 Hz really.
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

/// As it is called: 30, 60 or 120.
[[nodiscard]] constexpr int nominalHertz(PathRate rate) {
    return 1920 / ticksPerPoint(rate);
}

/// The longest segment, in counts either way: the magnitude has 14, 13 or 12 bits.
[[nodiscard]] constexpr std::int32_t maxPathCounts(PathRate rate) {
    return 256 * ticksPerPoint(rate) - 1;
}

/// One segment of a path: so many counts at constant speed.
struct PathPoint {
    std::int32_t counts = 0;
    PathRate rate = PathRate::Hz60;
    bool operator==(const PathPoint&) const = default;
};

/// The word on the wire: bit 0 reverse, bit 1 F, above them the magnitude, left-justified. F means 30 Hz, or
/// 60 Hz with fast path; its absence 60 or 120 Hz. Without those two bits it is the speed in 1/256 count per
/// tick. Nothing when the rate does not exist with or without fast path, or the segment is too long.
[[nodiscard]] std::optional<std::uint16_t> toPathWord(const PathPoint& point, bool fastPath);

/// Nothing when a bit is set that its rate wants zero.
[[nodiscard]] std::optional<PathPoint> fromPathWord(std::uint16_t word, bool fastPath);

}  // namespace nmc::servo
