// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "link/guardian/descriptor.h"
#include "protocol/baud.h"

namespace nmc {

/// The first action of a host on its side of a pseudo-terminal.
enum class FirstAct : std::uint8_t {
    Unknown,
    Wrote,        ///< bytes; settings may have followed
    SetTerminal,  ///< tcsetattr(3) or tcflush(3); bytes may have followed
};

/// What a host has done on its side of the terminal since the last query.
struct HostActs {
    std::vector<std::uint8_t> bytes;
    std::optional<std::uint32_t> baud;  ///< its present rate; empty at B0, which means "hang up"
    /// Valid when the rate has changed. Unknown also when more than that was done at once.
    FirstAct first = FirstAct::Unknown;
    /// It has closed the port after all or some of the bytes, and may have opened it again.
    bool hungUp = false;
};

/// The master side of a pseudo-terminal, which a host program opens as a serial port. Free of Qt. The slave
/// side is kept open here as well, so that a host may close and reopen it.
class PtyServer {
public:
    /// Creates a raw terminal of mode 0600, at the modules' power-up rate unless another is given, and, with
    /// a non-empty `link`, a symbolic link to it. The error is a sentence.
    [[nodiscard]] static tl::expected<PtyServer, std::string> create(const std::string& link,
                                                                     std::uint32_t baud = kPowerUpBaud);
    PtyServer(PtyServer&&) noexcept = default;
    PtyServer& operator=(PtyServer&&) = delete;
    /// Removes the link if it still points here.
    ~PtyServer();

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Descriptors for poll(2), readable when there are bytes, or any actions; the latter is -1 where the
    /// system provides no watch.
    [[nodiscard]] int fd() const { return m_master.get(); }
    [[nodiscard]] int actsFd() const { return m_order.get(); }
    /// Readable when a host has closed its side; the loop of a server that polls regularly needs none.
    [[nodiscard]] int leavesFd() const { return m_leaves.get(); }
    /// After a hang-up, whatever the host has not read by now is lost, as with any port that is closed.
    [[nodiscard]] HostActs takeActs();
    /// Returns only the bytes.
    [[nodiscard]] std::vector<std::uint8_t> read() const { return readAll().bytes; }
    /// Bytes that a host does not read for a long time are lost, as on a real line.
    void write(ByteSpan bytes) const;

private:
    /// The result of read(2) in packet mode.
    struct Packets {
        std::vector<std::uint8_t> bytes;
        unsigned news = 0;  ///< TIOCPKT_...
    };

    PtyServer() = default;
    /// Begins to observe what a host does first, and whether it leaves. The terminal itself does not show
    /// this: it accepts bytes at once, tcdrain(3) returns at once, and by the time the bytes are read, the
    /// host may have set its next rate. But the kernel reports both within the host's own call, a write by
    /// inotify(7) and a setting by packet mode (ioctl_tty(2), TIOCPKT), and epoll(7) keeps the order. The
    /// terminal must be in packet mode, with EXTPROC in its settings.
    void watchHost();
    /// The first action since the last call. Call it before reading the bytes and the packet mode's news.
    [[nodiscard]] FirstAct takeFirstAct() const;
    /// Reads everything that the host has written, up to far more than a line can carry in any short time.
    [[nodiscard]] Packets readAll() const;

    Descriptor m_master;
    Descriptor m_slave;
    std::string m_path;
    std::string m_link;
    Descriptor m_writes;          ///< inotify
    Descriptor m_leaves;          ///< inotify
    Descriptor m_order;           ///< epoll; invalid where the system provides none
    bool m_tellsSettings = true;  ///< the host has left EXTPROC set
    unsigned m_ownNews = 0;       ///< TIOCPKT_... caused by this side, not by the host
};

}  // namespace nmc
