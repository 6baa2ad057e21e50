// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"

/// The monotonic clocks of this program, including Qt's timers. They stand still until set() advances them,
/// so that an hour takes seconds, and what depends on time comes out the same each time. The kernel keeps its
/// own time.
namespace nmc::virtualtime {

/// May be called from any thread.
[[nodiscard]] TimePoint now();
/// Must not go backwards. Called by one thread at a time.
void set(TimePoint time);

}  // namespace nmc::virtualtime
