// SPDX-License-Identifier: MIT
#include "link/clock.h"

#include <sys/prctl.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace nmc {

TimePoint monotonicNow() {
    return TimePoint(std::chrono::steady_clock::now().time_since_epoch());
}

Duration asleepSoFar() {
    const auto read = [](clockid_t clock) {
        timespec time{};
        ::clock_gettime(clock, &time);
        return std::chrono::seconds(time.tv_sec) + Duration(time.tv_nsec);
    };
    const Duration awake = read(CLOCK_MONOTONIC);
    return read(CLOCK_BOOTTIME) - awake;
}

void wantFineTimers() {
    ::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
}

int pollUntil(std::span<pollfd> fds, std::optional<TimePoint> until) {
    timespec wait{};
    if (until) {
        const auto ns = std::max(Duration::zero(), *until - monotonicNow()).count();
        wait.tv_sec = ns / 1'000'000'000;
        wait.tv_nsec = ns % 1'000'000'000;
    }
    const int ready = ::ppoll(fds.data(), fds.size(), until ? &wait : nullptr, nullptr);
    return ready < 0 && errno == EINTR ? 0 : ready;
}

}  // namespace nmc
