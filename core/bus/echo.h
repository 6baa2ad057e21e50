// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "protocol/frame.h"

namespace nmc::bus {

/// Determines whether the adapter returns what is sent to it, as half-duplex RS-485 does (faults.md F-46),
/// and where its echo of a command ends and the answer may begin. Only an exact match is an echo: the whole
/// command, byte by byte, before anything that is taken for its answer. An adapter that begins or ceases to
/// echo, for example because of a switch on it, costs the exchange in which this shows. Pure.
class Echo {
public:
    /// True if an echo of what is sent is expected.
    [[nodiscard]] bool expected() const { return m_expected; }

    /// A command is sent. If the last one came back completely, this one is expected to as well.
    void begin(const PacketBytes& command) {
        m_expected = m_expected || whole();
        m_command = command;
        m_matched = 0;
        m_none = false;
    }
    /// The command was answered without coming back: echoes are no longer expected.
    void cease() {
        m_expected = false;
        m_matched = 0;
    }

    /// Takes the next byte from the line. Returns true if it continues the echo. An expected echo may follow
    /// other bytes, from before the command; one that is not expected counts only if it comes first.
    bool take(std::uint8_t byte) {
        if (m_none || m_matched == m_command.size())
            return false;
        if (byte != m_command[m_matched]) {
            m_matched = 0;  // this byte may be the first one of the actual echo
            m_none = !m_expected;
        }
        const bool goesOn = !m_none && byte == m_command[m_matched];
        m_matched += goesOn ? 1U : 0U;
        return goesOn;
    }
    /// Part of the command has come back, including the last byte.
    [[nodiscard]] bool begun() const { return m_matched > 0; }
    /// The whole command has come back.
    [[nodiscard]] bool whole() const { return begun() && m_matched == m_command.size(); }
    /// Number of bytes that have not come back yet.
    [[nodiscard]] std::size_t missing() const { return m_expected ? m_command.size() - m_matched : 0; }

private:
    PacketBytes m_command;
    std::size_t m_matched = 0;
    bool m_none = false;      ///< other bytes came first
    bool m_expected = false;  ///< since a command came back completely, until cease()
};

}  // namespace nmc::bus
