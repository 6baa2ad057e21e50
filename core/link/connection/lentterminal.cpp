// SPDX-License-Identifier: MIT
#include "link/connection/lentterminal.h"

#include <sys/epoll.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace nmc {

tl::expected<LentTerminal, LendingProblem> LentTerminal::create(const std::string& path, std::uint32_t baud,
                                                                int wakeFd) {
    struct stat info {};
    // PtyServer replaces a link, but only one that leads nowhere is certainly unused.
    const bool taken =
        ::stat(path.c_str(), &info) == 0 || (::lstat(path.c_str(), &info) == 0 && !S_ISLNK(info.st_mode));
    if (taken)
        return tl::unexpected(LendingProblem{LendingProblem::Kind::Taken, path, {}});
    auto terminal = PtyServer::create(path, baud);
    if (!terminal)
        return tl::unexpected(LendingProblem{LendingProblem::Kind::System, path, terminal.error()});
    LentTerminal lent(std::move(*terminal), path, baud);
    lent.m_wait = Descriptor(::epoll_create1(EPOLL_CLOEXEC));
    for (const int fd :
         {wakeFd, lent.m_terminal.fd(), lent.m_terminal.actsFd(), lent.m_terminal.leavesFd()}) {
        epoll_event event{};
        event.events = EPOLLIN;
        // Without it, the bus thread would wait for the line alone, and hear no stop.
        if (fd >= 0 && ::epoll_ctl(lent.m_wait.get(), EPOLL_CTL_ADD, fd, &event) != 0)
            return tl::unexpected(
                LendingProblem{LendingProblem::Kind::System, path,
                               std::string("it cannot be watched: ") + std::strerror(errno)});
    }
    return lent;
}

LentTerminal::Acts LentTerminal::takeActs(std::uint32_t chainRate) {
    HostActs acts = m_terminal.takeActs();
    const std::size_t before = m_rateOrder.beforeNewRate(acts, m_baud, m_baud == chainRate);
    const auto at = acts.bytes.begin() + static_cast<std::ptrdiff_t>(before);
    Acts done{{acts.bytes.begin(), at}, {}, {at, acts.bytes.end()}, false};
    if (acts.baud && std::exchange(m_baud, *acts.baud) != *acts.baud)
        done.baud = acts.baud;
    done.left = acts.hungUp && m_used;
    m_used = m_used || !acts.bytes.empty();
    return done;
}

}  // namespace nmc
