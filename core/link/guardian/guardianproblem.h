// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// Why no guardian stops the motors when the panel cannot.
enum class GuardianProblem : std::uint8_t {
    Missing,       ///< there is no such program
    NotPermitted,  ///< the system lets this user not start it
    WrongVersion,  ///< it is of another version, or no guardian at all
    Failed,        ///< the system has no memory or descriptor left
    Ended,         ///< it was there, and is no more
};

}  // namespace nmc
