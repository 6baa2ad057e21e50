// SPDX-License-Identifier: MIT
#pragma once

#include "model/settings/axisscale.h"
#include "protocol/servocommands.h"

namespace nmc {

/// Gains to begin with on a motor that nothing is known of but its axis (DS-V 4.3, 5.2 Set Gain): they hold
/// and move it gently, bring it to rest where it belongs in spite of its friction, and let go early. Counts
/// and PWM values as the chip takes them. Never sent by themselves. Pure.
///
/// The output is limited to a quarter of the supply. The integral may not add more than a sixteenth of it:
/// without any, a common motor stops several counts off, and with much it winds up behind a jam. The position
/// error limit is a quarter of the motor's turn where the axis says what a turn is.
[[nodiscard]] servo::SetGain startingGains(const AxisUnit& unit);

}  // namespace nmc
