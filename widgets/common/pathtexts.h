// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "link/files/machineio.h"
#include "model/path/pathdrawing.h"
#include "model/path/pathfile.h"
#include "model/path/pathplan.h"
#include "model/procedure/procedure.h"
#include "widgets/common/sequencetexts.h"

/// The part of the table of texts about paths.
namespace nmc::texts {

/// "Line 4, X: …", for a file with these axes.
[[nodiscard]] QString pathProblem(const PathProblem& problem, const std::vector<PathColumn>& axes);
/// Why a path cannot be run now.
[[nodiscard]] QString pathObstacle(const PathObstacle& obstacle, servo::PathRate rate,
                                   const ScaleOfAxis& scale);
/// Why no path can be made from a sequence.
[[nodiscard]] QString drawingProblem(const DrawingProblem& problem);
/// Why a path file could not be opened.
[[nodiscard]] QString pathNotRead(const FileError& error);
/// Why a path ended early. The messages of the modules say which axis was the cause.
[[nodiscard]] QString pathFailure(ProcedureFailure failure);
/// The progress of a path, or how it ended.
[[nodiscard]] QString pathState(const ProcedureReport& report);
/// "X from 0 mm to 12.5 mm": the range that a path covers on an axis.
[[nodiscard]] QString pathReach(const PathTable::Column& column, const PathColumn& axis);
/// "1 200 points at 60 Hz, 19.7 s"
[[nodiscard]] QString pathLength(const PathTable& table);

}  // namespace nmc::texts
