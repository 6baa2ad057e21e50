// SPDX-License-Identifier: MIT
#include "link/terminal/firstact.h"

#include <sys/epoll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>

namespace nmc {

namespace {

/// True when inotify has reported anything since the last call.
bool tookEvents(const Descriptor& inotify) {
    bool any = false;
    for (std::array<char, 4096> events{}; ::read(inotify.get(), events.data(), events.size()) > 0;)
        any = true;
    return any;
}

}  // namespace

FirstActWatch::FirstActWatch(int master, const std::string& path)
    : m_writes(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      m_leaves(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      m_order(::epoll_create1(EPOLL_CLOEXEC)) {
    ::inotify_add_watch(m_leaves.get(), path.c_str(), IN_CLOSE_WRITE);
    const auto watch = [this](int fd, unsigned events, FirstAct act) {
        epoll_event event{};
        event.events = events | unsigned{EPOLLET};
        event.data.u32 = static_cast<std::uint32_t>(act);
        return ::epoll_ctl(m_order.get(), EPOLL_CTL_ADD, fd, &event) == 0;
    };
    if (::inotify_add_watch(m_writes.get(), path.c_str(), IN_MODIFY) < 0 ||
        !watch(m_writes.get(), EPOLLIN, FirstAct::Wrote) || !watch(master, EPOLLPRI, FirstAct::SetTerminal))
        m_order.reset();
}

FirstAct FirstActWatch::take() const {
    if (!m_order.valid())
        return FirstAct::Unknown;
    std::array<epoll_event, 2> acts{};
    const int count = ::epoll_wait(m_order.get(), acts.data(), static_cast<int>(acts.size()), 0);
    // A write is reported only while no earlier write is waiting to be read.
    tookEvents(m_writes);
    return count > 0 ? static_cast<FirstAct>(acts[0].data.u32) : FirstAct::Unknown;
}

bool FirstActWatch::tookLeave() const {
    return tookEvents(m_leaves);
}

}  // namespace nmc
