// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/time.h"
#include "model/intent/motion.h"
#include "protocol/servocommands.h"

namespace nmc {

/// How the command position of a PIC-SERVO gets to its goal.
enum class ResponseMethod : std::uint8_t {
    Profile,   ///< a move so fast that the profile reaches its goal in a single tick (DS-V 4.3)
    StopHere,  ///< Stop Motor with a position, which has no profile (DS-V 5.2); not version 1
    Move,      ///< no jump: a trapezoidal move at the user's own pace
};

/// A step, or a profiled move, that a motor was commanded to make, and the data needed to evaluate it.
struct ResponseTaken {
    TimePoint at;           ///< when the module latched the command, +- half a tick
    std::int32_t from = 0;  ///< the position that the servo held
    std::int32_t goal = 0;  ///< where the command position went
    double record = 0.0;    ///< s, from `at` on; after that, the motor was commanded to hold
    ResponseMethod method = ResponseMethod::Profile;
    servo::SetGain gains;  ///< in force
    ServoPace pace{};      ///< Move: the pace of its profile
    unsigned round = 1;    ///< its number in a series

    [[nodiscard]] bool isMove() const { return method == ResponseMethod::Move; }

    bool operator==(const ResponseTaken&) const = default;
};

}  // namespace nmc
