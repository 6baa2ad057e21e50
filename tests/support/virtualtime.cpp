// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtualtime.h"

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace nmc::virtualtime {

namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000;

std::int64_t systemTime(clockid_t clock) {
    timespec time{};
    ::syscall(SYS_clock_gettime, clock, &time);
    return time.tv_sec * kNanoseconds + time.tv_nsec;
}

/// Starts close to the system's time, so that what another thread waits for in the kernel is not long past,
/// and at a whole second, because Qt's coarse timers expire at round times.
std::atomic<std::int64_t>& clock() {
    static std::atomic<std::int64_t> time = (systemTime(CLOCK_MONOTONIC) / kNanoseconds + 1) * kNanoseconds;
    return time;
}

}  // namespace

TimePoint now() {
    return TimePoint(Duration(clock().load()));
}

void set(TimePoint time) {
    clock().store(time.time_since_epoch().count());
}

}  // namespace nmc::virtualtime

/// Replaces the function of the C library for everything that this program is linked with.
extern "C" int clock_gettime(clockid_t id, timespec* time) noexcept {
    switch (id) {
        case CLOCK_MONOTONIC:
        case CLOCK_MONOTONIC_RAW:
        case CLOCK_MONOTONIC_COARSE:
        case CLOCK_BOOTTIME: {
            const std::int64_t now = nmc::virtualtime::now().time_since_epoch().count();
            time->tv_sec = now / nmc::virtualtime::kNanoseconds;
            time->tv_nsec = now % nmc::virtualtime::kNanoseconds;
            return 0;
        }
        default:
            return static_cast<int>(::syscall(SYS_clock_gettime, id, time));
    }
}
