// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/time.h"
#include "bus/types.h"

namespace nmc::bus {

/// Whether gains that are tried hold a servo where it stands (DS-V 4.3), as its positions tell one by one.
/// Not so where it
///
/// - asks for more PWM than the output limit gives, by the error alone;
/// - swings three half cycles in a row that do not calm down: a stable loop that was pushed swings less each
///   time;
/// - is too far away.
///
/// Loops that are too stiff swing up from a count to all that their output limit gives within some 20 ms.
/// Positions in counts. Pure.
class TrialWatch {
public:
    TrialWatch(const servo::SetGain& tried, const GainTrial& trial) : m_tried(tried), m_trial(trial) {}

    /// The next position; why the gains are not to stay.
    [[nodiscard]] std::optional<TrialEnd> look(TimePoint time, std::int32_t position);

private:
    /// From where it stood to one side and back.
    struct HalfCycle {
        bool ahead = false;
        TimePoint last{};
        double peak = 0.0;
    };
    [[nodiscard]] bool swings(TimePoint now) const;

    servo::SetGain m_tried;
    GainTrial m_trial;
    std::vector<HalfCycle> m_halfCycles;  ///< oldest first, of the last second
};

}  // namespace nmc::bus
