// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "bus/types.h"
#include "model/frequency/frequencypoint.h"
#include "protocol/servocommands.h"

/// What a measured loop would do with other gains. Only the control filter differs, and that is known, so no
/// model of the motor is needed: L' = L C'/C. Pure.
namespace nmc {

/// C, the filter's output over its error in 1/256 PWM counts: Kp + Kd (1 - 1/z) + Ki/256 / (1 - 1/z), once
/// per servo tick. `hertz`: below half the servo rate.
[[nodiscard]] std::complex<double> filterAt(const servo::SetGain& gains, double hertz);

/// True if the filter was not C, or may not have been, while `point` was measured: OL cut off more than a
/// twentieth of its output, or IL may have cut off an integral that is more than a tenth of it.
[[nodiscard]] bool meetsLimits(const bus::SineRecord& record, const FrequencyPoint& point,
                               const servo::SetGain& gains, double amplitude);

/// What changes in the loop from one set of gains to another.
enum class LoopChange : std::uint8_t {
    None,
    Filter,    ///< only C
    Rate,      ///< SR: the motor is driven in other steps, so nothing can be said
    Deadband,  ///< DB: the drive is not that of a filter, so nothing can be said
};
[[nodiscard]] LoopChange changeOf(const servo::SetGain& from, const servo::SetGain& to);

/// `measured` with gains `from`, as it would be with gains `to`, of which only C may differ: from the
/// first frequency at which no limit was met to the last one before a limit was. The doubt is that of the
/// measurement, carried through. Where the loop would be unstable, T is not a response.
[[nodiscard]] std::vector<FrequencyPoint> withOtherGains(std::span<const FrequencyPoint> measured,
                                                         const servo::SetGain& from,
                                                         const servo::SetGain& to);

}  // namespace nmc
