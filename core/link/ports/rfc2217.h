// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/bytes.h"

namespace nmc {

/// The client's side of a serial port through Telnet (RFC 2217, RFC 854): what is said to the device server
/// stands between the bytes of the line, which are the same in both directions but for a doubled 0xFF. Takes
/// bytes and returns bytes; owns no socket.
class Rfc2217 {
public:
    /// Asks for binary transmission in both directions and for the control of the port, and sets 8N1 without
    /// flow control.
    Rfc2217();

    /// Returns what of it is bytes of the line. Anything else is handled, or ignored if it is nonsense.
    [[nodiscard]] std::vector<std::uint8_t> take(ByteSpan received);
    /// Bytes of the line as they must be sent.
    [[nodiscard]] static std::vector<std::uint8_t> encoded(ByteSpan bytes);
    /// The command that sets the rate.
    [[nodiscard]] static std::vector<std::uint8_t> settingBaud(std::uint32_t baud);
    /// Bytes to send to the server now.
    [[nodiscard]] std::vector<std::uint8_t> takeOutput() { return std::exchange(m_output, {}); }

    /// Whether the server lets the port be controlled; empty until it has answered.
    [[nodiscard]] std::optional<bool> agreed() const { return m_agreed; }
    void setBaud(std::uint32_t baud);
    /// The rate that the server has set after the last setBaud(); empty until it has answered.
    [[nodiscard]] std::optional<std::uint32_t> baud() const { return m_baud; }
    /// Drops what the server has received and not passed on.
    void purgeInput();

private:
    enum class State : std::uint8_t { Data, Command, Option, Subnegotiation, SubnegotiationCommand };

    void answer(std::uint8_t verb, std::uint8_t option);
    void takeSubnegotiation();
    void say(std::initializer_list<std::uint8_t> bytes) { m_output.insert(m_output.end(), bytes); }
    [[nodiscard]] static std::vector<std::uint8_t> ofPort(std::uint8_t command, ByteSpan value);
    void say(const std::vector<std::uint8_t>& bytes) {
        m_output.insert(m_output.end(), bytes.begin(), bytes.end());
    }

    State m_state = State::Data;
    std::uint8_t m_verb = 0;
    std::vector<std::uint8_t> m_subnegotiation;
    std::vector<std::uint8_t> m_output;
    /// Verbs and options that were answered: each is answered once, so that the two ends cannot go on
    /// forever.
    std::set<std::pair<std::uint8_t, std::uint8_t>> m_answered;
    std::optional<bool> m_agreed;
    std::optional<std::uint32_t> m_baud;
};

}  // namespace nmc
