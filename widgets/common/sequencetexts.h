// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "link/dryrun/dryrun.h"
#include "model/sequence/sequencerun.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"

/// What the table of texts has to say of points and sequences.
namespace nmc::texts {

/// Of an axis, as its user reads it.
using ScaleOfAxis = std::function<AxisScale(ModuleIndex)>;

/// "move to", "wait"... of the actions in their order.
[[nodiscard]] QString actionWord(std::size_t action);
/// "limit 1", "IN1"...
[[nodiscard]] QString pinWord(InputPin pin);
/// "Module 1: 12.5 mm", of all axes of a point.
[[nodiscard]] QString placesOf(const Point& point, const ScaleOfAxis& scale);
/// Why it cannot be started: a sentence with its row.
[[nodiscard]] QString sequenceProblem(const SequenceProblem& problem);
/// Where it is, or how it ended.
[[nodiscard]] QString sequenceState(const SequenceReport& report);
/// Of one that is over; nothing where its user has ended it.
[[nodiscard]] std::optional<Message> sequenceOver(const SequenceReport& report);
/// It was not begun.
[[nodiscard]] Message sequenceNotBegun(const SequenceProblem& problem);
/// How long it would take, where each axis would go, and what would be refused.
[[nodiscard]] QString foreseen(const DryRun& dryRun, const ScaleOfAxis& scale);

}  // namespace nmc::texts
