// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/bytes.h"
#include "base/time.h"
#include "link/guardian/guardianproblem.h"

namespace nmc {

/// Stops the motors when the bus loop no longer can, because its process has crashed, was killed, or hangs.
/// The loop provides everything needed for that in advance. Bus thread; only begin() and end() may block, and
/// beat() while the guard has the line.
class LoopGuard {
public:
    /// Maximum interval between two beats while anything moves.
    static constexpr Duration kBeatEvery = std::chrono::milliseconds(50);

    /// Changes of the guard, or of what it guards, since the last beat.
    struct News {
        /// The loop stood still, and a guard sent the stop to the motors: the port's rate and the assumed
        /// state of the modules are no longer certain.
        bool stoppedMotors = false;
        /// Set when the guard is missing or has failed: from now on there is no guard.
        std::optional<GuardianProblem> problem{};
    };

    LoopGuard() = default;
    LoopGuard(const LoopGuard&) = delete;
    LoopGuard& operator=(const LoopGuard&) = delete;
    virtual ~LoopGuard() = default;

    /// Called when a port has been opened; -1 is the simulator in this process, which ends with it.
    virtual void begin(int fd) = 0;
    /// Sets the bytes that stop the motors, nulls first, and the rate to send them at; empty when there is
    /// nothing to stop. Called after each change of the three arguments, before the command that causes the
    /// change is sent.
    virtual void arm(ByteSpan burst, std::uint32_t baud, bool moving) = 0;
    /// Reports that the loop is alive; called in each iteration.
    [[nodiscard]] virtual News beat(TimePoint now) = 0;
    /// Called when the loop has done what it could and the port is about to be closed.
    virtual void end() = 0;
};

}  // namespace nmc
