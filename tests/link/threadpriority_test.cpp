// SPDX-License-Identifier: GPL-3.0-or-later
// What the system reports about a thread that requested to be preferred.
#include "link/threadpriority.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace nmc::test {

namespace {

struct Scheduling {
    int policy = -1;
    int nice = 0;
};

[[nodiscard]] Scheduling ofThisThread() {
    return {::sched_getscheduler(0) & ~SCHED_RESET_ON_FORK,
            ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()))};
}

TEST(ThreadPreference, IsWhatTheSystemGrantedAndStaysWithItsThread) {
    const Scheduling before = ofThisThread();
    ThreadPreference preference{};
    Scheduling preferred;
    Scheduling child;
    std::thread([&] {
        preference = preferThisThread();
        preferred = ofThisThread();
        std::thread([&] { child = ofThisThread(); }).join();
    }).join();
    RecordProperty("preference", static_cast<int>(preference));
    switch (preference) {
        case ThreadPreference::RealTime:
            EXPECT_EQ(preferred.policy, SCHED_RR);
            EXPECT_EQ(child.policy, SCHED_OTHER) << "a thread that it starts is an ordinary one";
            break;
        case ThreadPreference::Nice:
            EXPECT_EQ(preferred.policy, SCHED_OTHER);
            EXPECT_LT(preferred.nice, before.nice);
            EXPECT_GE(child.nice, 0);
            break;
        case ThreadPreference::None:
            EXPECT_EQ(preferred.policy, before.policy);
            EXPECT_EQ(preferred.nice, before.nice);
            break;
    }
    EXPECT_EQ(ofThisThread().policy, before.policy) << "other threads are left alone";
    EXPECT_EQ(ofThisThread().nice, before.nice);
}

}  // namespace

}  // namespace nmc::test
