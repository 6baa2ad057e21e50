// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "module/modulecommand.h"

namespace nmc {

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

/// What a module shows once it has carried out a command that nobody answered (link.md 2.3).
enum class Evidence : std::uint8_t {
    None,
    Motion,      ///< it moves, or has moved
    Position,    ///< its counter is 0
    Home,        ///< its home register is its position
    StickyBits,  ///< they are clear
};

/// When a command may go out (DS-V 4.4 and 5.1, DS-S 5.1, link.md 1).
enum class When : std::uint8_t {
    Always,
    Never,       ///< the engine sends it by a task of its own, or nobody does
    Standstill,  ///< the motor stands still, under power or not
    OffThePath,  ///< the module does not run through path points
    MotorOff,    ///< the servo is off and nothing moves
    AsLoaded,    ///< what has been loaded, or set before, decides: gate.cpp
};

enum class Effect : std::uint8_t {
    None,     ///< a question, which every chip of the family understands
    Setting,  ///< of what the module keeps or puts out
    Counter,  ///< another position: what was reported before does not compare
    Start,    ///< a motion may begin
    Stop,
};

/// What the engine knows of a command besides its bytes.
struct CommandFacts {
    RetryRule retry;
    Evidence evidence;
    When when;
    Effect effect;
};

/// One row for each command, in commandfacts.cpp. It goes by the command and not by its code, which means
/// Stop Motor to a PIC-SERVO and Set Synch Output to a PIC-I/O.
[[nodiscard]] CommandFacts factsOf(const ModuleCommand& command);

[[nodiscard]] inline RetryRule retryRule(const ModuleCommand& command) {
    return factsOf(command).retry;
}
/// Once such a command may have been carried out, standstill has to be proved again.
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
