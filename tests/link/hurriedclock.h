// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"

/// Replaces the clock of link/clock.h in a program in which one thread waits for points in time: they come at
/// once as long as another thread allows it, and otherwise time stands still. Threads still meet each other
/// as they do in real time, but no test waits for a motor, and no time passes for one thread while the
/// computer gives the other none.
namespace nmc::hurriedclock {

/// From now on, this much time may pass, and no more. May be called from any thread.
void allow(Duration time);

}  // namespace nmc::hurriedclock
