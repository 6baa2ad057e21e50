// SPDX-License-Identifier: MIT
#include "link/guardian/stopburst.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "link/clock.h"
#include "link/ports/linerate.h"
#include "protocol/baud.h"

namespace nmc {

namespace {

/// A port that no longer accepts bytes must not block the process that writes the last ones.
constexpr Duration kPatience = std::chrono::seconds(1);
constexpr int kPatienceMs = 1'000;

bool writeAll(int fd, ByteSpan bytes) {
    while (!bytes.empty()) {
        const auto n = ::write(fd, bytes.data(), bytes.size());
        if (n > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(n));
            continue;
        }
        if (n < 0 && errno == EINTR)
            continue;
        pollfd writable{fd, POLLOUT, 0};
        if (n == 0 || errno != EAGAIN || ::poll(&writable, 1, kPatienceMs) <= 0)
            return false;
    }
    return true;
}

}  // namespace

std::optional<StopBurst> StopBurst::of(ByteSpan bytes, std::uint32_t baud) {
    if (bytes.size() > kCapacity)
        return std::nullopt;
    StopBurst burst;
    burst.baud = baud;
    burst.size = static_cast<std::uint32_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), burst.bytes.begin());
    return burst;
}

bool waitUntilSent(int fd, Duration limit) {
    const TimePoint until = monotonicNow() + limit;
    int queued = 0;
    while (::ioctl(fd, TIOCOUTQ, &queued) == 0 && queued > 0) {
        const TimePoint now = monotonicNow();
        if (now >= until)
            return false;
        pollUntil({}, std::min(until, now + kLookEvery));
    }
    return true;
}

bool sendBurst(int fd, const StopBurst& burst) {
    std::uint32_t baud = lineRate(fd).value_or(kPowerUpBaud);
    if (burst.baud != 0 && burst.baud != baud) {
        waitUntilSent(fd, kPatience);
        setLineRate(fd, burst.baud);
        baud = burst.baud;
    }
    if (!writeAll(fd, burst.span()))
        return false;
    // A driver's queue is empty before that of the adapter, so the transmission time of the bytes is added.
    pollUntil({}, monotonicNow() + byteTimeAtBaud(std::max(baud, kBaudRows.front().nominal)) * burst.size);
    return waitUntilSent(fd, kPatience);
}

}  // namespace nmc
