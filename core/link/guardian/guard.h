// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace nmc {

/// How a guardian ends, as the exit code of its process.
enum class GuardEnd : int {
    Told = 0,         ///< the panel ended in order
    Outlived = 1,     ///< the panel died; its motors were told to stop, if any were left
    NotStarted = 2,   ///< whoever started this is no panel of this version
    PortVanished = 3  ///< hung up: there is no line left to stop anything on
};

/// The descriptors that a guardian is born with, behind the three standard ones.
struct GuardDescriptors {
    static constexpr int kPort = 3;
    static constexpr int kMemory = 4;
    static constexpr int kChannel = 5;  ///< a socket; the panel's end closes with the panel
    static constexpr int kPanel = 6;    ///< a pidfd of the panel, where the kernel has such
    static constexpr int kCount = 7;
};

/// The whole life of the guardian's process (link/guardian/guardian.h). Sleeps until the panel's next beat
/// would be too late, and while nothing moves until it is woken. Ignores what the terminal and the session
/// send to end a program: the panel gets that as well, stops its motors, and tells. `reportFile`: where it
/// says that it has stopped motors.
[[nodiscard]] GuardEnd runGuard(const std::string& reportFile);

}  // namespace nmc
