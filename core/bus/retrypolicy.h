// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "bus/types.h"

namespace nmc::bus {

/// What to do when nobody answered: the command may or may not have been carried out (link.md 2.3).
enum class AfterSilence : std::uint8_t {
    GiveUp,        ///< never blindly repeated: it could move twice, or carry out again what has been undone
    Repeat,        ///< after a resync; carrying it out twice changes nothing
    RepeatAtOnce,  ///< a stop: only nulls before it
};

struct RetryRule {
    AfterSilence afterSilence = AfterSilence::GiveUp;
    std::uint8_t silentRepeats = 0;
    std::uint8_t refusedAttempts = 3;  ///< in total, when the module says that it refused
    bool operator==(const RetryRule&) const = default;
};

/// The table of link.md 2.3. It asks which command it is: the code alone means one thing to a PIC-SERVO and
/// another to a PIC-I/O.
[[nodiscard]] RetryRule retryRule(const ModuleCommand& command);

/// Once it is carried out, "stands still" has to be shown anew.
[[nodiscard]] bool mayStartMotion(const ModuleCommand& command);

}  // namespace nmc::bus
