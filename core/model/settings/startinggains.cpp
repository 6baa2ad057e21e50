// SPDX-License-Identifier: MIT
#include "model/settings/startinggains.h"

#include <algorithm>
#include <cmath>

namespace nmc {

namespace {

/// Counts per turn of the most common encoder: 500 lines, 2000 counts.
constexpr double kCountsPerTurnUnknown = 2'000.0;
/// With a lower limit, a servo with these gains would trip at a push; and the upper limit keeps a runaway
/// short on a unit that turns after a gear.
constexpr double kMinErrorLimit = 100.0;
constexpr double kMaxErrorLimit = 2'000.0;

[[nodiscard]] std::uint16_t errorLimit(const AxisUnit& unit) {
    const double quarter = countsPerTurn(unit).value_or(kCountsPerTurnUnknown) / 4.0;
    return static_cast<std::uint16_t>(std::lround(std::clamp(quarter, kMinErrorLimit, kMaxErrorLimit)));
}

}  // namespace

servo::SetGain startingGains(const AxisUnit& unit) {
    servo::SetGain gains;
    gains.kp = 100;
    gains.kd = 1'000;
    gains.ki = 80;
    gains.il = 50;  // Ki * IL / 256 is 15.6 of 255
    gains.ol = 64;  // of 255
    gains.cl = 0;
    gains.el = errorLimit(unit);
    gains.sr = 1;
    gains.db = std::uint8_t{0};
    return gains;
}

}  // namespace nmc
