// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "protocol/frame.h"

namespace nmc::bus {

/// Whether the adapter returns what is sent to it, as half-duplex RS-485 does (faults.md F-46), and where
/// its echo of a command ends and the answer may begin. Only an exact match is an echo: the whole command,
/// byte by byte, before anything that is taken for its answer. An adapter that begins or ceases to echo, by
/// a switch on it say, costs the exchange that shows it. Pure.
class Echo {
public:
    /// What is sent comes back.
    [[nodiscard]] bool expected() const { return m_expected; }

    /// A command goes out. If the last one came back whole, this one is expected to.
    void begin(const PacketBytes& command) {
        m_expected = m_expected || whole();
        m_command = command;
        m_matched = 0;
        m_none = false;
    }
    /// The command was answered without coming back: it does no longer.
    void cease() {
        m_expected = false;
        m_matched = 0;
    }

    /// The next byte from the line. True when it goes on with the echo. One that is expected may come behind
    /// other bytes, from before the command; one that is not is nothing unless it comes first.
    bool take(std::uint8_t byte) {
        if (m_none || m_matched == m_command.size())
            return false;
        if (byte != m_command[m_matched]) {
            m_matched = 0;  // the byte may be the first one of the real thing
            m_none = !m_expected;
        }
        const bool goesOn = !m_none && byte == m_command[m_matched];
        m_matched += goesOn ? 1U : 0U;
        return goesOn;
    }
    /// Something of the command has come back, and what came last belongs to it.
    [[nodiscard]] bool begun() const { return m_matched > 0; }
    /// All of it has come back.
    [[nodiscard]] bool whole() const { return begun() && m_matched == m_command.size(); }
    /// So many bytes of it have not.
    [[nodiscard]] std::size_t missing() const { return m_expected ? m_command.size() - m_matched : 0; }

private:
    PacketBytes m_command;
    std::size_t m_matched = 0;
    bool m_none = false;      ///< what came first was something else
    bool m_expected = false;  ///< from a command that came back whole, to cease()
};

}  // namespace nmc::bus
