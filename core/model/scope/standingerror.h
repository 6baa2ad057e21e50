// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/standstill.h"
#include "model/scope/commandenvelope.h"

namespace nmc {

/// What a shaft at rest shows about a command position at rest: the deviation that friction and load cause is
/// about the same each time. The uncertainties of many motions therefore do not add up: what they add to the
/// band is taken back where it lies beyond the farthest that the shaft may have deviated with these gains.
/// Positions in counts. Pure.
class StandingError {
public:
    /// The command position begins to move from here.
    void leave(const CommandEstimate& command);
    /// The command position is not at rest.
    void move() { m_still.reset(); }
    /// Evaluates a status while the command position rests. Returns its position if that is now known more
    /// accurately, once per rest.
    [[nodiscard]] std::optional<CommandEstimate> look(TimePoint time, std::int32_t position, bool moving,
                                                      const CommandEstimate& command);

private:
    Standstill m_still;
    bool m_reported = false;
    double m_before = 0;               ///< half the band at the beginning of the last motions
    double m_own = 0;                  ///< largest half band left by a single motion
    double m_added = 0;                ///< by motions to half the band, since the largest deviation
    std::optional<double> m_farthest;  ///< largest possible deviation of the shaft so far
};

}  // namespace nmc
