// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <span>

#include "model/frequency/frequencyresponse.h"
#include "model/frequency/othergains.h"

/// Texts for the tests of a loop.
namespace nmc::texts {

/// One line for each figure, even if it was not reached; empty if there are no points.
[[nodiscard]] QStringList frequencyFigures(std::span<const FrequencyPoint> points);
/// What the loop that was measured would do with the gains in the fields, `predicted`, in one paragraph; or
/// why that is not known. `measured` must not be empty.
[[nodiscard]] QString wouldDo(std::span<const FrequencyPoint> measured,
                              std::span<const FrequencyPoint> predicted, LoopChange change);

}  // namespace nmc::texts
