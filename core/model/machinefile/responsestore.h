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

/// The number of runs stored for a machine.
inline constexpr std::size_t kMaxKeptRuns = 100;
/// Longer files are not read; kMaxKeptRuns runs of the longest record stay below this.
inline constexpr std::size_t kMaxRunFile = 64'000'000;
/// File name extension of run files.
inline constexpr std::string_view kRunFileSuffix = "runs";

/// Writes JSON, like a machine file. Reading it yields exactly the same runs, except for the time of the
/// step, which is meaningful only within one session and is not stored.
[[nodiscard]] std::string writeResponses(std::span<const KeptResponse> runs);
/// Returns all runs, marked as runs of an earlier session, or the problem.
[[nodiscard]] tl::expected<std::vector<KeptResponse>, FileProblem> readResponses(std::string_view text);

/// Identifies a run, whatever its number.
[[nodiscard]] std::string idOf(const KeptResponse& run);

/// Removes the oldest runs until kMaxKeptRuns are left, those without name and note first, but none that is
/// `needed`.
void dropOldest(std::vector<KeptResponse>& runs, const std::function<bool(const KeptResponse&)>& needed = {});

/// Merges the runs for the file: `ours`, and those already in it, which another session may have written,
/// except `gone`. Oldest first; a run whose number is taken gets the next number.
[[nodiscard]] std::vector<KeptResponse> together(std::vector<KeptResponse> ours,
                                                 const std::vector<KeptResponse>& there,
                                                 const std::set<std::string>& gone);

}  // namespace nmc
