// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>

#include <optional>
#include <span>

#include "base/time.h"

namespace nmc {

/// The monotonic clock: the only source of time.
[[nodiscard]] TimePoint monotonicNow();

/// How long this machine has been suspended since boot.
[[nodiscard]] Duration asleepSoFar();

/// Makes this thread's timers fire when they are due instead of up to 50 us later.
void wantFineTimers();

/// poll(2) with a deadline of nanosecond resolution; without one it waits forever. Returns what poll returns;
/// an interrupting signal counts as nothing ready.
int pollUntil(std::span<pollfd> fds, std::optional<TimePoint> until);

}  // namespace nmc
