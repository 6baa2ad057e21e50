// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/response/responserecord.h"

namespace nmc {

struct DrivePoint {
    double seconds = 0.0;  ///< since the step command was latched
    double error = 0.0;    ///< counts: command less position
    double pwm = 0.0;      ///< PWM counts, signed
};

/// What the control filter makes of a run (DS-V 4.3), with output limit and deadband compensation, without
/// the current limit: at the step itself, and at each sample behind it. Between samples the error is a
/// straight line, and what the integral held before the step, which nobody can know, counts as nothing. Pure.
[[nodiscard]] std::vector<DrivePoint> driveOf(const ResponseRecord& run);

}  // namespace nmc
