// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"

/// The monotonic clocks of this program, Qt's timers included: they stand still until they are set on. So an
/// hour takes seconds, and what depends on time comes out the same each time. The kernel keeps its own.
namespace nmc::virtualtime {

/// Any thread.
[[nodiscard]] TimePoint now();
/// Never backwards. By one thread at a time.
void set(TimePoint time);

}  // namespace nmc::virtualtime
