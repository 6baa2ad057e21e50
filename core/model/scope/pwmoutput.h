// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scope/scopesample.h"
#include "protocol/servocommands.h"

namespace nmc {

/// What a PIC-SERVO told its amplifier, rebuilt from its gains and the calculated error, because it reports
/// neither: the control filter of DS-V 4.3 with output limit and deadband compensation. PWM counts,
/// -255..255.
///
/// The bounds hold what is not known: the error's own band, which the filter sees rounded down; a count of
/// rounding in its change from tick to tick, which is a whole number, and how that differs before and after
/// the sample; the running sum, which is anything within the integration limit at first and becomes known
/// where that cuts it off; and with a current limit that has been exceeded anything down to 0. Pure.
class PwmOutput {
public:
    struct Value {
        TimePoint time;
        double likely = 0;
        double low = 0;
        double high = 0;
        bool gapBefore = false;
    };
    /// In the order of time, with the gains in force. Returns what is known by now of the sample before,
    /// since the change of the error at it takes one on either side. Nothing of a servo that is off, or whose
    /// error or gains are not known.
    [[nodiscard]] std::optional<Value> take(const ScopeSample& sample,
                                            const std::optional<servo::SetGain>& gains);

private:
    struct Range {
        double low = 0, likely = 0, high = 0;
    };
    /// Of the error, from one sample to the next.
    struct Change {
        double perTick = 0;  ///< counts
        bool none = false;   ///< in no tick between them: neither error nor shaft have moved
    };
    struct Known {
        ScopeSample sample;
        servo::SetGain gains;
        Range sum;  ///< running sum of the error
        std::optional<Change> changeBefore{};
    };
    [[nodiscard]] static Range advanced(const Known& before, const ScopeSample& to, double ticks);
    [[nodiscard]] std::optional<Value> finished(std::optional<Change> changeAfter);

    std::optional<Known> m_last;
    bool m_gap = true;  ///< before the next value
};

}  // namespace nmc
