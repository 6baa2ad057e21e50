// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/settings/axisscale.h"

namespace nmc {

/// The data on the labels of the parts between a motor's feedback and its load.
struct DriveTrain {
    /// Counts of a PIC-SERVO: four per line of the encoder (DS-V 3). Steps of a PIC-STEP: full steps times
    /// microsteps.
    double perMotorTurn = 0.0;
    // Gear ratio: `motorTurns` of the motor make `outputTurns` of the output.
    double motorTurns = 1.0;
    double outputTurns = 1.0;
    /// mm per turn of the output: the lead of a screw, or teeth times pitch of a belt. Used for lengths only.
    double travel = 0.0;
};

/// Counts (steps) per turn, degree or millimetre at the output of the drive. Nothing for other units, when a
/// number is missing, or when the result is not sensible (kMinCountsPerUnit). Pure.
[[nodiscard]] std::optional<double> countsPerUnit(UnitKind unit, const DriveTrain& drive);

}  // namespace nmc
