// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.h"
#include "bus/types.h"

namespace nmc::bus {

/// Determines from each position whether gains being tried hold a servo where it stands (DS-V 4.3). They do
/// not if it
///
/// - demands more PWM than the output limit allows, by the error alone;
/// - swings three consecutive half cycles that do not die down: a stable loop that was pushed swings less
///   each time;
/// - is too far away.
///
/// Loops that are too stiff swing up from a single count to their output limit within some 20 ms. Positions
/// in counts. Pure.
class TrialWatch {
public:
    TrialWatch(const servo::SetGain& tried, const GainTrial& trial) : m_tried(tried), m_trial(trial) {}

    /// Takes the next position. Returns why the gains must not stay, if so.
    [[nodiscard]] std::optional<TrialEnd> look(TimePoint time, std::int32_t position);

private:
    /// From the starting position to one side and back.
    struct HalfCycle {
        bool ahead = false;
        TimePoint last{};
        double peak = 0.0;
    };
    [[nodiscard]] bool swings(TimePoint now) const;

    servo::SetGain m_tried;
    GainTrial m_trial;
    std::vector<HalfCycle> m_halfCycles;  ///< oldest first, within the last second
};

}  // namespace nmc::bus
