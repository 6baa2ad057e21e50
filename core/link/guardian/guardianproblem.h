// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// Why no guardian stops the motors when the panel cannot.
enum class GuardianProblem : std::uint8_t {
    Missing,       ///< the program does not exist
    NotPermitted,  ///< this user may not start it
    WrongVersion,  ///< it has another version, or is not a guardian
    Failed,        ///< the system is out of memory or descriptors
    Ended,         ///< it was running and has ended
};

}  // namespace nmc
