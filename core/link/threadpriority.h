// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// What the system has granted.
enum class ThreadPreference : std::uint8_t {
    RealTime,  ///< precedes every ordinary thread
    Nice,      ///< gets a larger share of the processor than ordinary threads
    None,      ///< this user may have neither
};

/// A stop must not wait until the scheduler has served everybody else: the calling thread, which hardly ever
/// computes, is given precedence as far as the user's limits allow (RLIMIT_RTPRIO, RLIMIT_NICE,
/// CAP_SYS_NICE). Threads and processes that it starts do not inherit this. QThread's priorities have no
/// effect under Linux.
ThreadPreference preferThisThread();

}  // namespace nmc
