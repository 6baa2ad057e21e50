// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/servocommands.h"

namespace nmc::testing_support {

/// Gains with which the simulator's motor holds and moves.
inline constexpr servo::SetGain kGains{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}};

}  // namespace nmc::testing_support
