// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace nmc {

/// Runs work that a disk may delay in a thread of its own, without waiting for it. Any thread.
void inBackground(std::function<void()> work);

/// For tests: runs all work in `background` instead. Where time is virtual, the work must run at once in the
/// calling thread, because a disk does not wait for a stopped clock; or it runs when the test says so.
void setBackground(std::function<void(std::function<void()> work)> background);

}  // namespace nmc
