// SPDX-License-Identifier: MIT
#include "model/settings/drivetrain.h"

namespace nmc {

std::optional<double> countsPerUnit(UnitKind unit, const DriveTrain& drive) {
    const bool whole = drive.perMotorTurn > 0 && drive.motorTurns > 0 && drive.outputTurns > 0;
    if (!whole)
        return std::nullopt;
    const double perTurn = drive.perMotorTurn * drive.motorTurns / drive.outputTurns;
    double counts = 0;
    switch (unit) {
        case UnitKind::Turns:
            counts = perTurn;
            break;
        case UnitKind::Degrees:
            counts = perTurn / 360;
            break;
        case UnitKind::Millimetres:
            counts = drive.travel > 0 ? perTurn / drive.travel : 0;
            break;
        case UnitKind::Native:
        case UnitKind::Own:
            break;
    }
    const bool sensible = counts >= kMinCountsPerUnit && counts <= kMaxCountsPerUnit;
    return sensible ? std::optional(counts) : std::nullopt;
}

}  // namespace nmc
