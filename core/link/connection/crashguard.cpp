// SPDX-License-Identifier: MIT
#include "link/connection/crashguard.h"

#include "link/connection/crashburst.h"

namespace nmc {

void CrashGuard::begin(int fd) {
    m_fd = fd;
}

void CrashGuard::arm(ByteSpan burst, std::uint32_t baud, bool /*moving*/) {
    crashburst::arm(m_fd, burst, baud);
}

void CrashGuard::end() {
    crashburst::disarm();
    m_fd = -1;
}

}  // namespace nmc
