// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "model/module/modulestate.h"
#include "model/sequence/sequencerun.h"
#include "model/settings/machine.h"

namespace nmc {

struct DryRunStart {
    Machine machine;
    std::vector<ModuleState> modules;  ///< of the chain that is connected, as they are now
    std::string sequence;
    std::size_t row = 0;
    std::uint32_t baud = 115'200;
};

/// What a sequence would do.
struct DryRun {
    struct Axis {
        ModuleIndex module;
        std::int32_t lowest = 0;  ///< where it comes to, counts (steps) as its counter counts now
        std::int32_t highest = 0;
        double travelled = 0.0;  ///< all that it moves, there and back, counts
        unsigned moves = 0;
        bool operator==(const Axis&) const = default;
    };
    std::vector<SequenceProblem> problems;  ///< it would not be begun
    SequenceReport report;                  ///< how it ended
    double seconds = 0.0;
    std::vector<Axis> axes;  ///< those that moved
    // What it could not know:
    std::vector<ModuleIndex> homeAssumed;  ///< the search takes no time here, and ends where home is known
    bool inputsAssumed = false;            ///< what it waits for comes at once
    bool onceOnly = false;                 ///< "for ever" was done once
    bool tooLong = false;                  ///< it was not followed any farther than kLongestDryRun
    bool cancelled = false;

    [[nodiscard]] bool done() const { return problems.empty() && report.stage == SequenceStage::Done; }
};
inline constexpr double kLongestDryRun = 3'600.0;  ///< s of the sequence's own time

/// Runs the sequence on a simulated copy of the chain, with the panel's own engine, gains, parameters and
/// velocities, in virtual time. The copy begins where the axes stand; its motors are the simulator's. Pure;
/// it takes as long as it takes, so for a thread of its own.
[[nodiscard]] DryRun dryRun(const DryRunStart& start, const std::atomic<bool>& cancelled);

}  // namespace nmc
