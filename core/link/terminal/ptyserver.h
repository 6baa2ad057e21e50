// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "link/terminal/firstact.h"

namespace nmc {

/// What a host has done to its side of the terminal since it was last asked for.
struct HostActs {
    std::vector<std::uint8_t> bytes;
    std::optional<std::uint32_t> baud;  ///< its rate now; empty at B0, which is "hang up" and no rate
    /// Where the rate is another one now. Unknown, too, where more than that was done at once.
    FirstAct first = FirstAct::Unknown;
    /// It has closed the port, behind all of the bytes or some of them, and may have come back.
    bool hungUp = false;
};

/// The master side of a pseudo-terminal: what a host program opens as a serial port. Without Qt.
/// The slave side is kept open here as well, so a host may close and reopen it.
class PtyServer {
public:
    /// Makes a raw terminal of mode 0600 at 19 200 Bd and, with a non-empty `link`, a symbolic link to it. An
    /// error is a sentence.
    [[nodiscard]] static tl::expected<PtyServer, std::string> create(const std::string& link);
    PtyServer(PtyServer&& other) noexcept;
    PtyServer& operator=(PtyServer&&) = delete;
    /// Removes the link, if it still leads here.
    ~PtyServer();

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// For poll(2): when there are bytes, and when there are any acts; the latter may be -1.
    [[nodiscard]] int fd() const { return m_master; }
    [[nodiscard]] int actsFd() const { return m_firstAct.fd(); }
    /// After a hang-up, what the host has not read by now is gone, as with any port that is closed.
    [[nodiscard]] HostActs takeActs();
    /// The bytes alone.
    [[nodiscard]] std::vector<std::uint8_t> read() const { return readAll().bytes; }
    /// Bytes that a host does not read for long are lost, as on a real line.
    void write(ByteSpan bytes) const;
    /// The rate of the host's side, 19 200 at first; empty at B0, which is "hang up" and no rate.
    [[nodiscard]] std::optional<std::uint32_t> hostBaud() const;

private:
    /// What read(2) gives in packet mode.
    struct Packets {
        std::vector<std::uint8_t> bytes;
        unsigned news = 0;  ///< TIOCPKT_...
    };

    PtyServer() = default;
    /// All that the host has written, up to far more than a line takes in any time.
    [[nodiscard]] Packets readAll() const;

    int m_master = -1;
    int m_slave = -1;
    std::string m_path;
    std::string m_link;
    FirstActWatch m_firstAct;
    bool m_tellsSettings = true;  ///< the host has left EXTPROC as it was
    unsigned m_ownNews = 0;       ///< TIOCPKT_... of what was done here, not by the host
};

}  // namespace nmc
