// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "model/machinefile/fileproblem.h"
#include "model/response/responsefile.h"

namespace nmc {

/// So many are kept of a machine.
inline constexpr std::size_t kMaxKeptRuns = 100;
/// Longer files are not read; as many runs of the longest record do not fill it.
inline constexpr std::size_t kMaxRunFile = 32'000'000;
/// How the name of a file of runs ends.
inline constexpr std::string_view kRunFileSuffix = "runs";

/// JSON, as a machine file. Reading it gives the same runs again, to the last bit; their time of the step,
/// which is of one session, is not there.
[[nodiscard]] std::string writeResponses(std::span<const KeptResponse> runs);
/// All of them, as runs of an earlier session, or why not.
[[nodiscard]] tl::expected<std::vector<KeptResponse>, FileProblem> readResponses(std::string_view text);

/// By which a run is known, whatever number it has.
[[nodiscard]] std::string idOf(const KeptResponse& run);

/// Takes the oldest off until there are kMaxKeptRuns, those that nobody has named or made a note of before
/// the others; none of `needed`.
void dropOldest(std::vector<KeptResponse>& runs, const std::function<bool(const KeptResponse&)>& needed = {});

/// What the file is to hold: `ours`, and of what is in it already, which another session may have written,
/// all but `gone`. Oldest first; of a number that is taken it gets the next that is free.
[[nodiscard]] std::vector<KeptResponse> together(std::vector<KeptResponse> ours,
                                                 const std::vector<KeptResponse>& there,
                                                 const std::set<std::string>& gone);

}  // namespace nmc
