// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "link/connection/loopguard.h"
#include "link/guardian/guardian.h"

namespace nmc {

/// The guard against the death and the standstill of this process: a guardian for each port
/// (link/guardian/guardian.h). A connection that gets none, or loses it, reports this once and continues.
class ProcessGuard : public LoopGuard {
public:
    explicit ProcessGuard(GuardianPlace place) : m_place(std::move(place)) {}

    void begin(int fd) override;
    void arm(ByteSpan burst, std::uint32_t baud, bool moving) override;
    [[nodiscard]] News beat(TimePoint now) override;
    void end() override;

private:
    /// Interval between checks that the guardian still lives.
    static constexpr Duration kLookEvery = std::chrono::seconds(1);

    GuardianPlace m_place;
    std::optional<Guardian> m_guardian;
    std::optional<GuardianProblem> m_problem;  ///< not yet reported
    TimePoint m_looked;
};

}  // namespace nmc
