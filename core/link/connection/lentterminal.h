// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "link/connection/workerevent.h"
#include "link/guardian/descriptor.h"
#include "link/terminal/ptyserver.h"
#include "link/terminal/rateorder.h"

namespace nmc {

/// The terminal at which a program has the line that is lent to it (docs/lending.md). Bus thread.
class LentTerminal {
public:
    /// What the program has done since the last query, in this order.
    struct Acts {
        std::vector<std::uint8_t> bytes;
        std::optional<std::uint32_t> baud;  ///< its new rate, if it is new
        std::vector<std::uint8_t> bytesAtNewRate;
        bool left = false;  ///< it has closed the terminal, at which it had sent something before
    };

    /// Creates a terminal at `path`, where nothing may be so far, at this rate. `wakeFd`: see waitFd().
    [[nodiscard]] static tl::expected<LentTerminal, LendingProblem> create(const std::string& path,
                                                                           std::uint32_t baud, int wakeFd);

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Readable when the program has done something, or `wakeFd` is.
    [[nodiscard]] int waitFd() const { return m_wait.get(); }
    /// `chainRate`: that of the modules.
    [[nodiscard]] Acts takeActs(std::uint32_t chainRate);
    void write(ByteSpan bytes) const { m_terminal.write(bytes); }
    /// The program has sent something.
    [[nodiscard]] bool used() const { return m_used; }
    /// Its present rate.
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }

private:
    LentTerminal(PtyServer terminal, std::string path, std::uint32_t baud)
        : m_terminal(std::move(terminal)), m_path(std::move(path)), m_baud(baud) {}

    PtyServer m_terminal;
    Descriptor m_wait;  ///< epoll
    std::string m_path;
    std::uint32_t m_baud;
    RateOrder m_rateOrder;
    bool m_used = false;
};

}  // namespace nmc
