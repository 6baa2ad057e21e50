// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/bytes.h"

namespace nmc {

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
    /// For poll(2).
    [[nodiscard]] int fd() const { return m_master; }
    [[nodiscard]] std::vector<std::uint8_t> read() const;
    /// Bytes that a host does not read for long are lost, as on a real line.
    void write(ByteSpan bytes) const;
    /// The rate of the host's side, 19 200 at first; empty at B0, which is "hang up" and no rate.
    [[nodiscard]] std::optional<std::uint32_t> hostBaud() const;

private:
    PtyServer() = default;

    int m_master = -1;
    int m_slave = -1;
    std::string m_path;
    std::string m_link;
};

}  // namespace nmc
