// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace nmc {

/// How a guardian ends; also the exit code of its process.
enum class GuardEnd : int {
    PanelEnded = 0,   ///< the panel ended normally
    Outlived = 1,     ///< the panel died; the stop was sent if any motors were left to stop
    NotStarted = 2,   ///< the starting program is not a panel of this version
    PortVanished = 3  ///< hung up: there is no line left on which to stop anything
};

/// The descriptors that a guardian inherits, after the three standard ones.
struct GuardDescriptors {
    static constexpr int kPort = 3;
    static constexpr int kMemory = 4;
    static constexpr int kChannel = 5;  ///< a socket; the panel's end closes with the panel
    static constexpr int kPanel = 6;    ///< a pidfd of the panel, where the kernel supports it
    static constexpr int kCount = 7;
};

/// The entire life of the guardian's process (link/guardian/guardian.h). It sleeps until the panel's next
/// beat would be overdue, or while nothing moves, until it is woken. It ignores the signals with which the
/// terminal and the session end a program: the panel receives them too, stops its motors, and informs the
/// guardian. `reportFile`: where it reports that it has stopped motors.
[[nodiscard]] GuardEnd runGuard(const std::string& reportFile);

}  // namespace nmc
