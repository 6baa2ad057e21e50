// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/servocommands.h"

namespace nmc {

/// The amplifier output that a step demands, in PWM counts (255 is full on), before deadband compensation and
/// current limiting.
struct PwmDemand {
    int wanted = 0;  ///< lower bound, as if there were no output limit
    int limit = 0;   ///< OL

    /// True if the highest output was exactly the limit. Otherwise output() is only a lower bound: a later
    /// tick may have demanded more.
    [[nodiscard]] bool limited() const { return wanted >= limit; }
    [[nodiscard]] int output() const { return limited() ? limit : wanted; }

    bool operator==(const PwmDemand&) const = default;
};

/// Computes the demand at the tick at which the command jumps: |Kp e + Kd (e - e_before)| / 256 (DS-V 4.3),
/// errors in counts. The host does not know the integral; at worst, it opposes with the full Ki x IL.
[[nodiscard]] PwmDemand pwmDemand(const servo::SetGain& gains, double errorBefore, double error);

}  // namespace nmc
