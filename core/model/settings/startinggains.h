// SPDX-License-Identifier: MIT
#pragma once

#include "model/settings/axisscale.h"
#include "protocol/servocommands.h"

namespace nmc {

/// Initial gains for a motor of which only the axis is known (DS-V 4.3, 5.2 Set Gain): they hold and move it
/// gently, bring it to rest at its goal in spite of friction, and switch off early. Counts and PWM values in
/// the chip's units. Never sent automatically. Pure.
///
/// The output is limited to a quarter of the supply. The integral may add at most a sixteenth of it: without
/// an integral, a common motor stops several counts off, and with a large one it winds up against a jam. The
/// position error limit is a quarter turn of the motor if the axis defines a turn.
[[nodiscard]] servo::SetGain startingGains(const AxisUnit& unit);

}  // namespace nmc
