// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// What a direction check has come to.
enum class DirectionVerdict : std::uint8_t {
    Right,        ///< positive drive counts up, negative down
    Reversed,     ///< the other way round: with the servo on it would run away
    NoMovement,   ///< not with the strongest push either, and motor power is there
    LimitClosed,  ///< a limit input became active, so it was not pushed on
    NoPower,      ///< motor power went away meanwhile
    Unclear,      ///< it moved the same way twice, or one way only: something else turns or blocks it
};

struct DirectionFound {
    DirectionVerdict verdict = DirectionVerdict::Unclear;
    std::int32_t forward = 0;        ///< counts that it moved when it was pushed forward; 0: not seen to move
    std::int32_t reverse = 0;        ///< the same in reverse, negative when it counted down
    std::uint8_t strongestPush = 0;  ///< PWM
    bool limit1 = false;             ///< active at the end
    bool limit2 = false;

    bool operator==(const DirectionFound&) const = default;
};

}  // namespace nmc
