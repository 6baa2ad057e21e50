// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/connection/wakeup.h"

#include <gtest/gtest.h>

#include <array>

#include "link/clock.h"

namespace nmc {
namespace {

bool awake(const Wakeup& wakeup) {
    std::array<pollfd, 1> fds{{{wakeup.fd(), POLLIN, 0}}};
    return pollUntil(fds, TimePoint{}) == 1;  // a time long past: look, do not wait
}

TEST(Wakeup, StaysAwakeUntilItIsReset) {
    const Wakeup wakeup;
    EXPECT_FALSE(awake(wakeup));
    wakeup.wake();
    wakeup.wake();
    EXPECT_TRUE(awake(wakeup));
    EXPECT_TRUE(awake(wakeup));
    wakeup.reset();
    EXPECT_FALSE(awake(wakeup));
}

}  // namespace
}  // namespace nmc
