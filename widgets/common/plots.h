// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What all plots share, so that they look and behave alike.

namespace nmc {

inline constexpr double kTraceWidth = 1.6;  ///< px
inline constexpr double kWheelZoom = 1.25;  ///< for each notch
inline constexpr double kKeyZoom = 1.5;     ///< for each press
inline constexpr int kBandAlpha = 45;       ///< of 255: opacity of areas behind lines

}  // namespace nmc
