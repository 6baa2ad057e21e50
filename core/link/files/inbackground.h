// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace nmc {

/// Does what a disk may hold up, in a thread of its own that nobody waits for. Any thread.
void inBackground(std::function<void()> work);

/// For tests in virtual time: from now on it is done at once, in the thread that asks, since a disk does not
/// wait for a clock that stands still.
void workAtOnce();

}  // namespace nmc
