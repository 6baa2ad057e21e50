// SPDX-License-Identifier: MIT
#pragma once

#include "link/connection/crashburst.h"
#include "link/connection/loopguard.h"

namespace nmc {

/// The guard against a crash of this process: its signal handlers write the burst (crashburst.h). Only one
/// may exist at a time.
class CrashGuard : public LoopGuard {
public:
    void begin(int fd) override { m_fd = fd; }
    void arm(ByteSpan burst, std::uint32_t baud, bool /*moving*/) override {
        crashburst::arm(m_fd, burst, baud);
    }
    [[nodiscard]] News beat(TimePoint /*now*/) override { return {}; }
    void end() override {
        crashburst::disarm();
        m_fd = -1;
    }

private:
    int m_fd = -1;
};

}  // namespace nmc
