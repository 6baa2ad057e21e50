// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace nmc {

/// In one radian.
inline constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace nmc
