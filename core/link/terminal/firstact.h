// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "link/guardian/descriptor.h"

namespace nmc {

/// The first action of a host on its side of a pseudo-terminal.
enum class FirstAct : std::uint8_t {
    Unknown,
    Wrote,        ///< bytes; settings may have followed
    SetTerminal,  ///< tcsetattr(3) or tcflush(3); bytes may have followed
};

/// Observes what a host does first, and whether it leaves. The terminal itself does not show this: it accepts
/// bytes at once, tcdrain(3) returns at once, and by the time the bytes are read, the host may have set its
/// next rate. But the kernel reports both within the host's own call, a write by inotify(7) and a setting by
/// packet mode (ioctl_tty(2), TIOCPKT), and epoll(7) keeps the order.
class FirstActWatch {
public:
    FirstActWatch() = default;
    /// `master` must be in packet mode, with EXTPROC in the terminal's settings; `path` is the host's side.
    FirstActWatch(int master, const std::string& path);

    /// The first action since the last call. Call it before reading the bytes and the packet mode's news.
    [[nodiscard]] FirstAct take() const;
    /// True when a host has closed its side since the last call.
    [[nodiscard]] bool tookLeave() const;
    /// Descriptor for poll(2), readable when there is something to take; -1 where the system provides no
    /// watch.
    [[nodiscard]] int fd() const { return m_order.get(); }
    /// The same for tookLeave().
    [[nodiscard]] int leavesFd() const { return m_leaves.get(); }

private:
    Descriptor m_writes;  ///< inotify
    Descriptor m_leaves;  ///< inotify
    Descriptor m_order;   ///< epoll; invalid where the system provides none
};

}  // namespace nmc
