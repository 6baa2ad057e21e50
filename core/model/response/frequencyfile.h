// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/frequency/frequencypoint.h"
#include "model/recording/recording.h"

namespace nmc {

/// CSV for spreadsheets: one row per frequency, magnitudes in dB, phases in degrees. The C locale is used
/// regardless of the user's; lines end in a line feed. The modules of `origin` are not listed, only the
/// measured one, by its name. The line about the speed is there if it was not 0. `gains`: those with which it
/// was measured; their time does not matter.
///
///     # NMC Panel frequency response 1
///     # program: NMC Panel 0.6.0
///     # started: 2026-11-21T21:21:02.123+01:00
///     # port: simulator
///     # simulated: yes (no real motor moved)
///     # module: Module 1
///     # gains of module 1 at 0.000000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 0
///     # speed while measuring: 5000 counts/s
///     frequency_hz,closed_db,closed_deg,closed_doubt,open_db,open_deg
[[nodiscard]] std::string frequencyCsv(const RecordingHeader& origin, std::string_view module,
                                       std::span<const FrequencyPoint> points, const GainsChange& gains,
                                       double speed = 0.0);

}  // namespace nmc
