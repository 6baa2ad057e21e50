// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// The result of a direction check.
enum class DirectionVerdict : std::uint8_t {
    Right,        ///< positive drive counts up, negative down
    Reversed,     ///< the other way round: with the servo on, the motor would run away
    NoMovement,   ///< no movement even with the strongest push, although motor power is on
    LimitClosed,  ///< a limit input became active, so the pushes were ended
    NoPower,      ///< motor power went off during the check
    Unclear,      ///< it moved the same way twice, or one way only: something else turns or blocks it
};

struct DirectionFound {
    DirectionVerdict verdict = DirectionVerdict::Unclear;
    std::int32_t forward = 0;        ///< counts moved by the forward push; 0: no movement seen
    std::int32_t reverse = 0;        ///< counts moved by the reverse push; negative when it counted down
    std::uint8_t strongestPush = 0;  ///< PWM
    bool limit1 = false;             ///< active at the end
    bool limit2 = false;

    bool operator==(const DirectionFound&) const = default;
};

}  // namespace nmc
