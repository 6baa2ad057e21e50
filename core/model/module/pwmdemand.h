// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/servocommands.h"

namespace nmc {

/// What a step asks of the amplifier, PWM counts (255 is full on), before deadband compensation and current
/// limiting.
struct PwmDemand {
    int wanted = 0;  ///< at least, if there were no output limit
    int limit = 0;   ///< OL

    /// The highest output was the limit, exactly. Otherwise output() is only a lower bound: a later tick may
    /// have asked for more.
    [[nodiscard]] bool limited() const { return wanted >= limit; }
    [[nodiscard]] int output() const { return limited() ? limit : wanted; }

    bool operator==(const PwmDemand&) const = default;
};

/// At the tick at which the command jumps: |Kp e + Kd (e - e_before)| / 256 (DS-V 4.3), errors in counts. The
/// integral is not known to the host: at worst it pulls the other way with all of Ki x IL.
[[nodiscard]] PwmDemand pwmDemand(const servo::SetGain& gains, double errorBefore, double error);

}  // namespace nmc
