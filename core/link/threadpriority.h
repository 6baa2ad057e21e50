// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// How far the system went along.
enum class ThreadPreference : std::uint8_t {
    RealTime,  ///< goes before every ordinary thread
    Nice,      ///< gets more of the processor than those
    None,      ///< this user may not
};

/// A stop must not wait until the scheduler has served everybody else: the calling thread, which hardly ever
/// computes, goes before the others as far as the user may have that (RLIMIT_RTPRIO, RLIMIT_NICE,
/// CAP_SYS_NICE). Threads and processes that it starts do not inherit it. QThread's priorities do nothing
/// here under Linux.
ThreadPreference preferThisThread();

}  // namespace nmc
