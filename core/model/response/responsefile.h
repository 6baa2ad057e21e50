// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/response/responserecord.h"
#include "model/settings/axisscale.h"

namespace nmc {

/// A step response with the labels shown wherever it is listed or saved.
struct KeptResponse {
    int number = 0;    ///< from 1
    std::string name;  ///< given by the user, UTF-8, like the note
    std::string note;
    ResponseRecord run;
    std::string startedAt;   ///< start of the step, ISO 8601 with the zone offset
    std::string moduleName;  ///< UTF-8
    std::string axisName;    ///< the user's name for the axis, by which it is recognized; may be empty
    AxisScale scale;
    std::string port;
    bool simulated = false;
    bool earlier = false;  ///< from an earlier session or connection: the motor may be another one since
};

/// The moves that were made together with this one, in order, as far as they are in the list; of a step,
/// only itself. `run` is one of `runs`, which are in the order of their numbers.
[[nodiscard]] std::vector<const KeptResponse*> seriesOf(std::span<const KeptResponse> runs,
                                                        const KeptResponse& run);

/// CSV for spreadsheets and people: comments that describe each run, then one row per sample. UTF-8, line
/// feeds, the C locale regardless of the user's:
///
///     # NMC Panel step responses 1
///     # program: NMC Panel 0.6.0
///     # run 1 started: 2026-11-21T21:21:02.123+01:00
///     # run 1 port: simulator
///     # run 1 simulated: yes (no real motor moved)
///     # run 1 module: Module 1
///     # run 1 counts per unit: 1
///     # run 1 step: 0 to 100 counts by a profile of one tick
///     # gains of module 1 at 0.000000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 0
///     # run 1 rise: 0.012 s +- 0.001
///     # ...
///     run,time_s,position,from_start,error
///     1,-0.0195,3,0,-3
///
/// Figures that could not be measured are omitted.
[[nodiscard]] std::string responsesCsv(std::string_view program, std::span<const KeptResponse> runs);

}  // namespace nmc
