// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/module/modulestate.h"
#include "model/sequence/sequencerun.h"
#include "model/settings/machine.h"

namespace nmc {

inline constexpr double kLongestDryRun = 3'600.0;  ///< s of the sequence's own time

struct DryRunStart {
    Machine machine;
    std::vector<ModuleState> modules;  ///< modules of the connected chain in their present state
    std::string sequence;
    std::size_t row = 0;
    std::uint32_t baud = 115'200;
    double longest = kLongestDryRun;
};

/// The result of running a sequence on a copy.
struct DryRun {
    struct Axis {
        ModuleIndex module;
        std::int32_t lowest = 0;  ///< lowest position reached, counts (steps) in its counter's present frame
        std::int32_t highest = 0;
        double travelled = 0.0;  ///< total distance moved in both directions, counts
        unsigned moves = 0;
        bool operator==(const Axis&) const = default;
    };
    std::vector<SequenceProblem> problems;  ///< reasons why it would not start
    SequenceReport report;                  ///< how it ended
    double seconds = 0.0;
    std::vector<Axis> axes;  ///< only axes that moved
    // Assumptions made where the copy lacks information:
    std::vector<ModuleIndex> homeAssumed;  ///< home searches that took no time and ended where home is known
    bool inputsAssumed = false;            ///< inputs that rows wait for occurred at once
    bool onceOnly = false;                 ///< an endless repetition was run once
    bool tooLong = false;                  ///< the run was cut off after DryRunStart::longest
    bool cancelled = false;
    /// Set if the report says nothing about the sequence: the copy ended it early because the motor of
    /// `report.module` could not be switched on there as it is in reality, for this reason.
    std::optional<Refusal> leftOff{};

    [[nodiscard]] bool done() const { return problems.empty() && report.stage == SequenceStage::Done; }
};

/// Runs the sequence on a simulated copy of the chain in virtual time, with the panel's own engine, gains,
/// parameters and velocities. The copy starts at the axes' present positions; its motors are the simulator's
/// default motors. Pure; it may take long, so it belongs in its own thread.
[[nodiscard]] DryRun dryRun(const DryRunStart& start, const std::atomic<bool>& cancelled);

}  // namespace nmc
