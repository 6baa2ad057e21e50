// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

/// What becomes of a line that is lent to a program (docs/lending.md). Plain values; any thread.
namespace nmc {

/// Why the line could not be lent.
struct LendingProblem {
    enum class Kind : std::uint8_t {
        NotNow,  ///< a motor moves, something is in progress, no chain, or a read-only connection
        Taken,   ///< there is something at the path
        System,  ///< see `reason`
    };
    Kind kind = Kind::NotNow;
    std::string path;
    std::string reason;  ///< of the system
};

/// The line is lent to a program (docs/lending.md), or no longer.
struct LineLent {
    enum class State : std::uint8_t {
        Waiting,  ///< for a program
        InUse,    ///< a program has sent something
        HeldOff,  ///< by a stop of all modules
        Left,     ///< over: the program has closed the terminal
        Ended,    ///< over, for any other reason
    };
    State state = State::Waiting;
    std::string path;
};

}  // namespace nmc
