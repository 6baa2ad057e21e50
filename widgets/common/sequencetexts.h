// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "link/dryrun/dryrun.h"
#include "model/sequence/sequencerun.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"

/// The part of the table of texts about points and sequences.
namespace nmc::texts {

/// The scale in which the user reads an axis.
using ScaleOfAxis = std::function<AxisScale(ModuleIndex)>;

/// "move to", "wait"... `action`: the index of an alternative of Action.
[[nodiscard]] QString actionWord(std::size_t action);
/// "limit 1", "IN1"...
[[nodiscard]] QString pinWord(InputPin pin);
/// "Module 1: 12.5 mm from home", for all axes of a point.
[[nodiscard]] QString placesOf(const Point& point, const ScaleOfAxis& scale);
/// Why a sequence cannot be started: a sentence, with the row if it has one.
[[nodiscard]] QString sequenceProblem(const SequenceProblem& problem);
/// Where a run is, or how it ended.
[[nodiscard]] QString sequenceState(const SequenceReport& report);
/// The message about a run that has ended; empty if the user ended it, or a stop of all motors did.
[[nodiscard]] std::optional<Message> sequenceOver(const SequenceReport& report);
/// Says that nothing was started, and why.
[[nodiscard]] Message sequenceNotBegun(const SequenceProblem& problem);
/// The result of a dry run: how long the sequence would take, where each axis would go, and what would be
/// refused.
[[nodiscard]] QString foreseen(const DryRun& dryRun, const ScaleOfAxis& scale);

}  // namespace nmc::texts
