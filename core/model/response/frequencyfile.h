// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "model/response/frequencypoint.h"

namespace nmc {

/// For spreadsheets: one row per frequency, magnitudes in dB, phases in degrees; the C locale whatever the
/// user's, line feeds:
///
///     frequency_hz,closed_db,closed_deg,closed_doubt,open_db,open_deg
[[nodiscard]] std::string frequencyCsv(std::span<const FrequencyPoint> points);

}  // namespace nmc
