// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "link/guardian/stopburst.h"

namespace nmc {

/// A guardian's report for the next start of the panel: it has sent the stop to motors, and to which.
struct GuardReport {
    long process = 0;  ///< process number of the panel it guarded
    /// Addresses of the modules that were sent the stop, in order; group addresses are not included.
    std::vector<std::uint8_t> modules;
};

/// Writes the report on this burst atomically: the file appears complete or not at all.
bool writeGuardReport(const std::string& file, const StopBurst& burst);

/// Returns the reports in a folder and removes them, so that each report reaches exactly one caller. Files
/// that are not reports are neither read nor removed.
[[nodiscard]] std::vector<GuardReport> takeGuardReports(const std::string& folder);

/// The file to which the calling process's guardian must write its report.
[[nodiscard]] std::string guardReportFile(const std::string& folder);

}  // namespace nmc
