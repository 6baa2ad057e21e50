// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"

/// Another clock in the place of link/clock.h, for a program of which one thread waits for times: they come
/// at once, as long as another thread allows it, and otherwise as fast as ever. So that threads meet each
/// other as they do, and nobody waits for a motor.
namespace nmc::hurriedclock {

/// From now on time may hurry for so long. Any thread.
void allow(Duration time);

}  // namespace nmc::hurriedclock
