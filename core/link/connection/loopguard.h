// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/bytes.h"
#include "base/time.h"
#include "link/guardian/guardianproblem.h"

namespace nmc {

/// Stops the motors when the bus loop cannot any more, because its process has crashed, has been killed or
/// hangs. The loop tells it all that takes beforehand. Bus thread; only begin() and end() may wait, and
/// beat() when the guard has the line.
class LoopGuard {
public:
    /// How long the loop may wait between two beats while anything moves.
    static constexpr Duration kBeatEvery = std::chrono::milliseconds(50);

    /// What has become of a guard, or of what it guards, since the last beat.
    struct News {
        /// The loop stood still, and the motors were told to stop without it: neither the port's rate nor
        /// what is believed of the modules is sure any more.
        bool stoppedMotors = false;
        /// From now on nobody guards.
        std::optional<GuardianProblem> problem{};
    };

    LoopGuard() = default;
    LoopGuard(const LoopGuard&) = delete;
    LoopGuard& operator=(const LoopGuard&) = delete;
    virtual ~LoopGuard() = default;

    /// A port has been opened; -1: the simulator in this process, which ends with it.
    virtual void begin(int fd) = 0;
    /// From now on these bytes, nulls first, are what stops the motors, at this rate; empty: nothing is on.
    /// After each change of the three, before the command that changes it leaves.
    virtual void arm(ByteSpan burst, std::uint32_t baud, bool moving) = 0;
    /// The loop lives. Each turn of it.
    [[nodiscard]] virtual News beat(TimePoint now) = 0;
    /// The loop has done what it could, and the port is about to be closed.
    virtual void end() = 0;
};

}  // namespace nmc
