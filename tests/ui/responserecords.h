// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/response/responsefile.h"
#include "windowtest.h"

namespace nmc {

/// A motor that moves in a straight line for 10 ms and then stays at `there`, with a sample every
/// millisecond.
inline KeptResponse ramp(double there = 100, int module = 0) {
    KeptResponse kept;
    kept.run.module = ModuleIndex(static_cast<std::uint8_t>(module));
    kept.run.taken = {
        TimePoint(std::chrono::seconds(1)), 500, 600, 0.1, ResponseMethod::Profile, someGains()};
    for (int ms = -10; ms <= 100; ++ms) {
        const double gone = ms < 0 ? 0 : ms > 10 ? there : there * ms / 10;
        kept.run.points.push_back({ms / 1'000.0, 500 + gone});
    }
    judge(kept.run, kFirstBand);
    kept.startedAt = "2026-11-21T21:21:02.123+01:00";
    kept.moduleName = "Module 1";
    kept.port = "simulator";
    kept.simulated = true;
    return kept;
}

}  // namespace nmc
