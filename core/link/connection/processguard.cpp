// SPDX-License-Identifier: MIT
#include "link/connection/processguard.h"

#include <utility>

namespace nmc {

void ProcessGuard::begin(int fd) {
    if (fd < 0)
        return;
    auto guardian = Guardian::start(fd, m_place);
    if (guardian)
        m_guardian.emplace(std::move(*guardian));
    else
        m_problem = guardian.error();
}

void ProcessGuard::arm(ByteSpan burst, std::uint32_t baud, bool moving) {
    if (m_guardian)
        m_guardian->arm(burst, baud, moving);
}

LoopGuard::News ProcessGuard::beat(TimePoint now) {
    News news;
    if (m_guardian)
        news.stoppedMotors = m_guardian->beat(now);
    if (m_guardian && now - m_looked >= kLookEvery) {
        m_looked = now;
        if (!m_guardian->alive()) {
            m_guardian.reset();
            m_problem = GuardianProblem::Ended;
        }
    }
    news.problem = std::exchange(m_problem, std::nullopt);
    return news;
}

void ProcessGuard::end() {
    m_guardian.reset();
    m_problem.reset();
}

}  // namespace nmc
