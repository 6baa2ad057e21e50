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

/// What the table of texts has to say of paths.
namespace nmc::texts {

/// "Line 4, X: …" of a file whose axes these are.
[[nodiscard]] QString pathProblem(const PathProblem& problem, const std::vector<PathColumn>& axes);
/// Why it cannot be run now.
[[nodiscard]] QString pathObstacle(const PathObstacle& obstacle, servo::PathRate rate,
                                   const ScaleOfAxis& scale);
/// Why a sequence makes no path.
[[nodiscard]] QString drawingProblem(const DrawingProblem& problem);
/// A file that could not be read.
[[nodiscard]] QString pathNotRead(const FileError& error);
/// Why one ended before its end. Which axis it was, the modules tell.
[[nodiscard]] QString pathFailure(ProcedureFailure failure);
/// How it goes, how it ended, or nothing where it has not begun.
[[nodiscard]] QString pathState(const ProcedureReport& report);
/// "X from 0 mm to 12.5 mm": where a path takes an axis.
[[nodiscard]] QString pathReach(const PathTable::Column& column, const PathColumn& axis);
/// "1 200 points at 60 Hz, 19.7 s"
[[nodiscard]] QString pathLength(const PathTable& table);

}  // namespace nmc::texts
