// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nmc::testing_support {

/// The servo tick of a PIC-SERVO, in seconds (DS-V 3.1).
inline constexpr double kTick = 0.000'512;

}  // namespace nmc::testing_support
