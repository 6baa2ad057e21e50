// SPDX-License-Identifier: MIT
#pragma once

#include "link/connection/loopguard.h"

namespace nmc {

/// The guard against a crash of this process: its signal handlers write the burst (crashburst.h). Only one
/// may exist at a time.
class CrashGuard : public LoopGuard {
public:
    void begin(int fd) override;
    void arm(ByteSpan burst, std::uint32_t baud, bool moving) override;
    [[nodiscard]] News beat(TimePoint /*now*/) override { return {}; }
    void end() override;

private:
    int m_fd = -1;
};

}  // namespace nmc
