// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scope/scopesample.h"
#include "protocol/servocommands.h"

namespace nmc {

/// A PIC-SERVO's output to its amplifier, reconstructed from its gains and the calculated error, because it
/// reports neither: the control filter of DS-V 4.3 with output limit and deadband compensation. PWM counts,
/// -255..255.
///
/// The bounds cover what is unknown: the error's own band, which the filter sees rounded down; one count of
/// rounding in its change from tick to tick, which is a whole number, and the difference of that change
/// before and after the sample; the running sum, which is initially anything within the integration limit and
/// becomes known where that limit cuts it off; and, with a current limit that has been exceeded, anything
/// down to 0. Pure.
class PwmOutput {
public:
    /// Samples must be in order of time, with the gains in force. Returns the value for the previous sample,
    /// because the change of the error at a sample needs a sample on either side. Returns nothing for a servo
    /// that is off, or whose error or gains are unknown.
    [[nodiscard]] std::optional<ScopeSample> take(const ScopeSample& sample,
                                                  const std::optional<servo::SetGain>& gains);

private:
    struct Range {
        double low = 0, likely = 0, high = 0;
    };
    /// Change of the error from one sample to the next.
    struct Change {
        double perTick = 0;  ///< counts
        bool none = false;   ///< in no tick between them have error or shaft moved
    };
    struct Known {
        ScopeSample sample;
        servo::SetGain gains;
        Range sum;  ///< running sum of the error
        std::optional<Change> changeBefore{};
    };
    [[nodiscard]] static Range advanced(const Known& before, const ScopeSample& to, double ticks);
    [[nodiscard]] std::optional<ScopeSample> finished(std::optional<Change> changeAfter);

    std::optional<Known> m_last;
    bool m_gap = true;  ///< a gap precedes the next value
};

}  // namespace nmc
