// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/response/responserecord.h"

namespace nmc {

struct DrivePoint {
    double seconds = 0.0;  ///< since the step command was latched
    double error = 0.0;    ///< counts: command minus position
    double pwm = 0.0;      ///< PWM counts, signed
};

/// Computes the output of the control filter for a run (DS-V 4.3), with output limit and deadband
/// compensation but without the current limit: at the step itself, and at each sample after it or after the
/// start of a profiled move. Between
/// samples the error is interpolated linearly. The integral before the step is unknown and is taken as zero.
/// Pure.
[[nodiscard]] std::vector<DrivePoint> driveOf(const ResponseRecord& run);

}  // namespace nmc
