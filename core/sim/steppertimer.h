// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// The clock of the step timer, encoded as bits 1,0 of Set Parameters (DS-S 4.1, 5.1).
enum class SpeedMode : std::uint8_t { X8 = 0, X4 = 1, X2 = 2, X1 = 3 };

/// The speed multiplier: 1, 2, 4 or 8.
[[nodiscard]] constexpr unsigned multiplier(SpeedMode mode) {
    return 8U >> static_cast<unsigned>(mode);
}

inline constexpr std::uint16_t kMinTimerCount = 1;
inline constexpr std::uint16_t kMaxTimerCount = 65'452;
inline constexpr std::uint8_t kMaxStepSpeed = 250;

/// The step rate: each nanosecond adds `weight` to a phase, and `perStep` of phase is one step. These are
/// integers, so that any period can be run in one go and no step is ever lost to rounding.
struct StepperRate {
    std::int64_t weight = 0;
    std::int64_t perStep = 1;

    [[nodiscard]] double stepsPerSecond() const {
        return 1e9 * static_cast<double>(weight) / static_cast<double>(perStep);
    }
};

/// Phase of one step in the profiled modes: a nanosecond at speed 1 adds 1, and speed 1 is 25 steps per
/// second at 1x (DS-S 4.2, Table 3).
[[nodiscard]] constexpr std::int64_t profilePerStep(SpeedMode mode) {
    return 40'000'000 / multiplier(mode);
}

/// The rate at an integer speed.
[[nodiscard]] constexpr StepperRate rateOfSpeed(SpeedMode mode, unsigned speed) {
    return {speed, profilePerStep(mode)};
}

/// The rate with an initial timer count: f / (65536 - count + k), from DS-S 4.1.
[[nodiscard]] constexpr StepperRate rateOfCount(SpeedMode mode, std::uint16_t count) {
    const unsigned m = multiplier(mode);
    const std::int64_t clocks = 65'536 - std::int64_t{count} + std::int64_t{2} * m;
    return {1, clocks * 1600 / m};  // 625 kHz is 1600 ns
}

/// The count nearest to an integer speed.
[[nodiscard]] constexpr std::uint16_t countOfSpeed(SpeedMode mode, unsigned speed) {
    const unsigned m = multiplier(mode);
    const unsigned clocks = (25'000 + speed / 2) / speed;  // f / (25 m) is 25 000 in every mode
    return static_cast<std::uint16_t>(65'536 - clocks + 2 * m);
}

}  // namespace nmc::sim
