// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/settings/axisscale.h"

namespace nmc {

/// What stands on the labels between a motor's feedback and what it moves.
struct DriveTrain {
    /// Counts of a PIC-SERVO: four for each line of the encoder (DS-V 3). Steps of a PIC-STEP: full steps
    /// times microsteps.
    double perMotorTurn = 0.0;
    // A gear: so many turns of the motor make so many of the output.
    double motorTurns = 1.0;
    double outputTurns = 1.0;
    /// mm for one turn of the output: the lead of a screw, teeth times pitch of a belt. Of lengths only.
    double travel = 0.0;

    bool operator==(const DriveTrain&) const = default;
};

/// Counts (steps) in one turn, degree or millimetre behind that drive. Nothing for a unit that it does not
/// tell, and where a number is missing or the result makes no sense (kMinCountsPerUnit). Pure.
[[nodiscard]] std::optional<double> countsPerUnit(UnitKind unit, const DriveTrain& drive);

}  // namespace nmc
