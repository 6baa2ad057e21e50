// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace nmc {

/// Does what a disk may hold up, in a thread of its own that nobody waits for. Any thread.
void inBackground(std::function<void()> work);

/// For tests: from now on `background` does it instead. At once, in the thread that asks, where time is
/// virtual, since a disk does not wait for a clock that stands still; or when the test says so.
void setBackground(std::function<void(std::function<void()> work)> background);

}  // namespace nmc
