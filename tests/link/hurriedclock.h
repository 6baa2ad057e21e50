// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"

/// Replaces the clock of link/clock.h in a program in which one thread waits for points in time: they come at
/// once as long as another thread allows it, and in real time otherwise. Threads still meet each other as
/// they do in real time, but no test waits for a motor.
namespace nmc::hurriedclock {

/// From now on, time may hurry for this long. May be called from any thread.
void allow(Duration time);

}  // namespace nmc::hurriedclock
