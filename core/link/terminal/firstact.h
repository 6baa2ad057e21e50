// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "link/guardian/descriptor.h"

namespace nmc {

/// What a host did first at its side of a pseudo-terminal.
enum class FirstAct : std::uint8_t {
    Unknown,
    Wrote,        ///< bytes; settings may have followed
    SetTerminal,  ///< tcsetattr(3) or tcflush(3); bytes may have followed
};

/// Watches what a host does first, and whether it goes. The terminal itself does not tell: it takes bytes at
/// once, tcdrain(3) returns at once, and by the time anybody reads, the host may have set its next rate. But
/// the kernel tells of both within the host's own call, of a write by inotify(7) and of a setting by packet
/// mode (ioctl_tty(2), TIOCPKT), and epoll(7) keeps the order.
class FirstActWatch {
public:
    FirstActWatch() = default;
    /// `master` must be in packet mode, with EXTPROC in the terminal's settings; `path` is the host's side.
    FirstActWatch(int master, const std::string& path);

    /// Since the last call. To be called before the bytes and the packet mode's news are read.
    [[nodiscard]] FirstAct take() const;
    /// Whether a host has closed its side since the last call.
    [[nodiscard]] bool tookLeave() const;
    /// For poll(2), there is something to take; -1 where the system gives no watch.
    [[nodiscard]] int fd() const { return m_order.get(); }

private:
    Descriptor m_writes;  ///< inotify
    Descriptor m_leaves;  ///< inotify
    Descriptor m_order;   ///< epoll; not valid where the system gives none
};

}  // namespace nmc
