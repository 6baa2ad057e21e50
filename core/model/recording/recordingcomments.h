// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "model/recording/recordingcells.h"
#include "model/recording/recordingreader.h"
#include "model/scope/history.h"

/// Parses the comments of a recording. For core/model/recording*.cpp only; pure.
namespace nmc::comments {

/// A problem in the line being read; the caller sets RecordingProblem::line.
[[nodiscard]] RecordingProblem problemOf(cells::Fault fault, std::string_view field, std::string_view found,
                                         cells::Bounds bounds);
/// Makes a text printable, whatever it is.
[[nodiscard]] std::string shown(std::string_view text);

/// Modules are numbered from 1.
inline constexpr cells::Bounds kModules{1, 255};
inline constexpr cells::Bounds kBytes{0, 255};

/// Reads "key: value" into the header. An unknown key changes nothing.
[[nodiscard]] std::optional<RecordingProblem> takeHeadEntry(std::string_view text, RecordingHeader& header);

/// Returns nothing when the text only resembles a comment on gains.
[[nodiscard]] std::optional<GainsChange> gainsOf(std::string_view text);

}  // namespace nmc::comments
