// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "link/guardian/stopburst.h"

namespace nmc {

/// What a guardian leaves behind for the next start of the panel: that it has told motors to stop, and which.
struct GuardReport {
    long process = 0;  ///< the panel whose guardian it was
    /// Addresses of the modules that were told, in order; those of groups are not among them.
    std::vector<std::uint8_t> modules;
};

/// Writes the report on this burst, in one piece or not at all.
bool writeGuardReport(const std::string& file, const StopBurst& burst);

/// The reports that lie in a folder, each to exactly one caller: they are gone afterwards. What is no report
/// of ours is neither read nor removed.
[[nodiscard]] std::vector<GuardReport> takeGuardReports(const std::string& folder);

/// Where the guardian of the calling process is to write its own.
[[nodiscard]] std::string guardReportFile(const std::string& folder);

}  // namespace nmc
