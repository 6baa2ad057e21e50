// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/link/hurriedclock.h"

#include <algorithm>
#include <atomic>
#include <ctime>

#include "link/clock.h"

namespace nmc {

namespace {

// Relaxed: the clock must not order what threads do, or the thread sanitizer would miss accesses that nothing
// else orders.
constexpr auto kOrder = std::memory_order_relaxed;
std::atomic<Duration::rep> g_now = Duration(std::chrono::seconds(1)).count();
std::atomic<Duration::rep> g_hurriesUntil = 0;

bool hurries(TimePoint until) {
    return until.time_since_epoch().count() <= g_hurriesUntil.load(kOrder);
}

}  // namespace

void hurriedclock::allow(Duration time) {
    g_hurriesUntil.store(g_now.load(kOrder) + time.count(), kOrder);
}

TimePoint monotonicNow() {
    return TimePoint(Duration(g_now.load(kOrder)));
}

Duration asleepSoFar() {
    return {};
}

void wantFineTimers() {}

int pollUntil(std::span<pollfd> fds, std::optional<TimePoint> until) {
    const Duration most = until ? std::max(Duration::zero(), *until - monotonicNow()) : Duration::max();
    const Duration wait = until && hurries(*until) ? Duration::zero() : most;
    const auto seconds = std::chrono::floor<std::chrono::seconds>(wait);
    timespec time{};
    time.tv_sec = seconds.count();
    time.tv_nsec = (wait - seconds).count();
    const int ready = ::ppoll(fds.data(), fds.size(), until ? &time : nullptr, nullptr);
    if (ready == 0 && until)
        g_now.store((monotonicNow() + most).time_since_epoch().count(), kOrder);
    return std::max(ready, 0);
}

}  // namespace nmc
