// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "model/settings/axisscale.h"

/// How strongly and how far a direction check may move the motor of a PIC-SERVO
/// (model/procedure/directioncheck.h). Pure.
namespace nmc {

/// PWM values, 255 is full supply voltage (DS-V 4.4): the first push, the increase from one push to the next,
/// and the strongest push, a quarter of the supply.
inline constexpr std::uint8_t kFirstPush = 4;
inline constexpr std::uint8_t kPushStep = 4;
inline constexpr std::uint8_t kStrongestPush = 64;
/// Distance in counts that distinguishes a motor that has moved from one that trembles at rest
/// (bus/standstill.h).
inline constexpr std::int32_t kMovedCounts = 10;

/// The distance from the starting position, in counts, at which the check ends, without a verdict if need be:
/// an eighth of a turn of the axis, or of 2000 counts where the axis does not define a turn; limited to 50 to
/// 1000.
[[nodiscard]] std::int32_t directionReach(const AxisUnit& unit);

}  // namespace nmc
