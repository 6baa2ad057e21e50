// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/standstill.h"
#include "model/scope/commandenvelope.h"

namespace nmc {

/// What a shaft that stands still says about a command position that does so too: what friction and load let
/// it stand off is about the same each time. So the doubts of many motions do not add up: each leaves its
/// own, or the farthest that the shaft may have stood off with these gains, whichever is more. Positions in
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
    bool m_told = false;
    double m_before = 0;               ///< half the band where the last motions began
    double m_own = 0;                  ///< half the band that a motion has left at most
    std::optional<double> m_farthest;  ///< so far off it may have stood
};

}  // namespace nmc
