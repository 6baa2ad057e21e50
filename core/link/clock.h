// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>

#include <optional>
#include <span>

#include "base/time.h"

namespace nmc {

/// The monotonic clock: the one place where time comes from.
[[nodiscard]] TimePoint monotonicNow();

/// How long this machine has been suspended since it was started.
[[nodiscard]] Duration asleepSoFar();

/// Asks for this thread's timers to fire when they are due instead of up to 50 us later.
void wantFineTimers();

/// poll(2) until a time point, to the nanosecond; without one, for ever. Returns what poll returns; an
/// interrupting signal counts as nothing ready.
int pollUntil(std::span<pollfd> fds, std::optional<TimePoint> until);

}  // namespace nmc
