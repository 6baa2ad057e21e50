// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/settings/axisscale.h"

/// How strongly and how far a direction check may move a PIC-SERVO's motor
/// (model/procedure/directioncheck.h). Pure.
namespace nmc {

/// PWM values, 255 is the whole supply (DS-V 4.4): the first push, by how much each is stronger than the one
/// before, and the strongest, a quarter.
inline constexpr std::uint8_t kFirstPush = 4;
inline constexpr std::uint8_t kPushStep = 4;
inline constexpr std::uint8_t kStrongestPush = 64;
/// Counts that tell a motor which has moved from one that stands and trembles (bus/standstill.h).
inline constexpr std::int32_t kMovedCounts = 10;

/// Counts from where it stood that end the check, and end it without a verdict: an eighth of a turn of the
/// axis, of 2000 counts where the axis does not say what a turn is; 50 to 1000.
[[nodiscard]] std::int32_t directionReach(const AxisUnit& unit);

}  // namespace nmc
