// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "link/connection/transport.h"
#include "link/guardian/descriptor.h"
#include "link/ports/networkline.h"
#include "link/ports/rfc2217.h"
#include "protocol/baud.h"

namespace nmc {

/// A serial line behind a network. A raw one stays at the rate that is set at the device server, which must
/// be kPowerUpBaud; at any other it is mute, so that a chain is not found where it is not, and the chain must
/// not be switched to another (hasFixedRate()). A peer that no longer acknowledges is noticed after some
/// seconds, and reported like an adapter that was unplugged.
class NetworkTransport : public Transport {
public:
    /// `name`: as the user has written it. `baud`: the rate that will be needed later; open() makes sure that
    /// the server can set it.
    NetworkTransport(NetworkLine line, std::string name, std::uint32_t baud = kPowerUpBaud);

    tl::expected<void, PortError> open() override;
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override;
    [[nodiscard]] bool hasFixedRate() const override { return !m_telnet; }
    tl::expected<void, PortError> send(ByteSpan bytes) override;
    void discardInput() override;
    Received receive(std::optional<TimePoint> until, int wakeFd) override;
    [[nodiscard]] int fd() const override { return m_socket.get(); }
    [[nodiscard]] std::vector<std::uint8_t> onWire(ByteSpan bytes, std::uint32_t baud) const override;
    [[nodiscard]] Duration latency() const override { return m_latency; }

private:
    tl::expected<void, PortError> connectTo();
    tl::expected<void, PortError> write(ByteSpan bytes);
    /// Sends what m_telnet has to say, and receives bytes of the line into m_early until it is answered, or
    /// not in time.
    template <typename Condition>
    tl::expected<void, PortError> ask(const Condition& answered);
    /// What has arrived so far; empty: nothing. An error if the connection has ended.
    Received read();
    [[nodiscard]] PortError problem(PortProblem what, int error = 0) const;

    NetworkLine m_line;
    std::string m_name;
    std::uint32_t m_baud;
    Descriptor m_socket;
    std::optional<Rfc2217> m_telnet;    ///< of an RFC 2217 line
    std::vector<std::uint8_t> m_early;  ///< bytes that arrived before an answer of the server
    Duration m_latency{};
    bool m_mute = false;  ///< a raw line is asked for a rate that it does not have
};

}  // namespace nmc
