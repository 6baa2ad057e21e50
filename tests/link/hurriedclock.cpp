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
std::atomic<Duration::rep> g_allowedUntil = 0;

/// Number of descriptors that are ready, at the latest after this real time.
int readyWithin(std::span<pollfd> fds, const timespec* time) {
    return std::max(::ppoll(fds.data(), fds.size(), time, nullptr), 0);
}

}  // namespace

void hurriedclock::allow(Duration time) {
    g_allowedUntil.store(g_now.load(kOrder) + time.count(), kOrder);
}

TimePoint monotonicNow() {
    return TimePoint(Duration(g_now.load(kOrder)));
}

Duration asleepSoFar() {
    return {};
}

void wantFineTimers() {}

int pollUntil(std::span<pollfd> fds, std::optional<TimePoint> until) {
    if (!until)
        return readyWithin(fds, nullptr);
    constexpr timespec kAtOnce{};
    constexpr timespec kSoon{0, 1'000'000};
    const Duration::rep end = until->time_since_epoch().count();
    while (true) {
        const Duration::rep now = g_now.load(kOrder);
        const Duration::rep next = std::min(end, g_allowedUntil.load(kOrder));
        // Beyond what is allowed, it looks again until more is.
        const int ready = readyWithin(fds, now >= end || next > now ? &kAtOnce : &kSoon);
        if (ready > 0 || now >= end)
            return ready;
        if (next > now)
            g_now.store(next, kOrder);
    }
}

}  // namespace nmc
