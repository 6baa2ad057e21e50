// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace nmc {

/// Degrees per radian.
inline constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace nmc
