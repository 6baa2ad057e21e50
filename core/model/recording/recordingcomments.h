// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "model/recording/recordingcells.h"
#include "model/recording/recordingreader.h"
#include "model/scope/gainschange.h"

/// What stands in the comments of a recording. For core/model/recording*.cpp only; pure.
namespace nmc::comments {

/// Of the line that is being read: RecordingProblem::line is set by the caller.
[[nodiscard]] RecordingProblem problemOf(cells::Fault fault, std::string_view field, std::string_view found,
                                         cells::Bounds bounds);
/// For a sentence, whatever it was.
[[nodiscard]] std::string shown(std::string_view text);

/// Modules are numbered from 1.
inline constexpr cells::Bounds kModules{1, 255};
inline constexpr cells::Bounds kBytes{0, 255};

/// "key: value", into the header. What is none of ours changes nothing.
[[nodiscard]] std::optional<RecordingProblem> takeHeadEntry(std::string_view text, RecordingHeader& header);

/// Nothing when it only looks like a comment on gains.
[[nodiscard]] std::optional<GainsChange> gainsOf(std::string_view text);

}  // namespace nmc::comments
