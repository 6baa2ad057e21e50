// SPDX-License-Identifier: MIT
#include "link/threadpriority.h"

#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace nmc {

namespace {

/// Enough to take precedence over desktop programs; what a machine needs to operate has lower values.
constexpr int kWantedNice = -11;

/// The lowest nice value that this user may have (getrlimit(2): 20 minus the limit).
[[nodiscard]] int allowedNice() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_NICE, &limit) != 0)
        return 0;
    return 20 - static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 40));
}

[[nodiscard]] bool setNice(int nice) {
    return ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), nice) == 0;
}

}  // namespace

ThreadPreference preferThisThread() {
    sched_param lowest{};
    lowest.sched_priority = ::sched_get_priority_min(SCHED_RR);
    if (::sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &lowest) == 0)
        return ThreadPreference::RealTime;
    const int allowed = std::max(allowedNice(), kWantedNice);
    if (!setNice(kWantedNice) && !(allowed < 0 && setNice(allowed)))
        return ThreadPreference::None;
    const sched_param usual{};
    ::sched_setscheduler(0, SCHED_OTHER | SCHED_RESET_ON_FORK, &usual);
    return ThreadPreference::Nice;
}

}  // namespace nmc
