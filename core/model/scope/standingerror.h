// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/standstill.h"
#include "model/scope/commandenvelope.h"

namespace nmc {

/// What a shaft at rest says about a command position at rest. Friction and load hold the shaft about as far
/// from it each time, so the uncertainty of many motions does not add up: what they add to the band is taken
/// back where it lies beyond the farthest that the shaft may have stood off with these gains. Positions in
/// counts. Pure.
class StandingError {
public:
    /// The command position begins to move from here.
    void leave(const CommandEstimate& command);
    /// It is not at rest.
    void move() { m_still.reset(); }
    /// A status while the command position rests. Where it must be then, if that is known better by now: once
    /// for each rest.
    [[nodiscard]] std::optional<CommandEstimate> look(TimePoint time, std::int32_t position, bool moving,
                                                      const CommandEstimate& command);

private:
    Standstill m_still;
    bool m_reported = false;
    double m_before = 0;               ///< half the band where the last motions began
    double m_own = 0;                  ///< half the band that a motion has left at most
    double m_added = 0;                ///< by motions to half the band, since the shaft stood farthest off
    std::optional<double> m_farthest;  ///< so far off it may have stood
};

}  // namespace nmc
