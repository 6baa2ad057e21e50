// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "module/modulecommand.h"

namespace nmc {

struct RetryRule {
    /// Repeats after silence, when the command may or may not have been carried out (link.md 2.3). 0: a
    /// repeat could move twice, or redo what has been undone since.
    std::uint8_t silentRepeats = 0;
    std::uint8_t refusedAttempts = 3;  ///< in total, when the module refuses the command (NAK)
    bool atOnce = false;               ///< a stop: repeats are preceded only by nulls, not by a resync
    bool operator==(const RetryRule&) const = default;
};

/// The evidence that a module has carried out an unanswered command (link.md 2.3).
enum class Evidence : std::uint8_t {
    None,
    Motion,      ///< the module moves, or has moved
    Position,    ///< the counter is 0
    Home,        ///< the home register equals the position
    StickyBits,  ///< the sticky bits are clear
};

/// When a command may be sent (DS-V 4.4 and 5.1, DS-S 5.1, link.md 1).
enum class When : std::uint8_t {
    Always,
    Never,       ///< sent only by a task of the engine, or not at all
    Standstill,  ///< the motor stands still, powered or not
    OffThePath,  ///< the module is not running path points
    MotorOff,    ///< the servo is off and nothing moves
    AsLoaded,    ///< depends on what was loaded or set before, or on whether the servo is on: gate.cpp
};

enum class Effect : std::uint8_t {
    None,     ///< a query, which every chip of the family understands
    Setting,  ///< changes a setting or an output of the module
    Counter,  ///< changes the position counter; earlier positions are not comparable
    Start,    ///< may start a motion
    Stop,
};

/// What the engine knows about a command apart from its bytes.
struct CommandFacts {
    RetryRule retry;
    Evidence evidence;
    When when;
    Effect effect;
};

/// Returns the command's row in commandfacts.cpp. Rows are by command and not by code, because one code means
/// Stop Motor to a PIC-SERVO and Set Synch Output to a PIC-I/O.
[[nodiscard]] CommandFacts factsOf(const ModuleCommand& command);

/// True if standstill must be proved again once such a command may have been carried out.
[[nodiscard]] inline bool mayStartMotion(const ModuleCommand& command) {
    return factsOf(command).effect == Effect::Start;
}
[[nodiscard]] inline bool setsCounter(const ModuleCommand& command) {
    return factsOf(command).effect == Effect::Counter;
}
[[nodiscard]] inline bool isQuestion(const ModuleCommand& command) {
    return factsOf(command).effect == Effect::None;
}

}  // namespace nmc
