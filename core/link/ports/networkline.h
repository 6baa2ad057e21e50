// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nmc {

/// A serial line behind a network: a device server with its host and TCP port. Pure.
struct NetworkLine {
    enum class Protocol : std::uint8_t {
        Raw,     ///< bytes as they are; the rate is what is set at the server
        Rfc2217  ///< the rate is set from here
    };
    Protocol protocol = Protocol::Raw;
    std::string host;  ///< name or address, without brackets
    std::uint16_t port = 0;
    bool operator==(const NetworkLine&) const = default;
};

/// True for a name that means a network line, right or wrong: "tcp://..." or "rfc2217://...".
[[nodiscard]] bool isNetworkName(std::string_view name);
/// Reads "tcp://HOST:PORT" or "rfc2217://HOST:PORT"; an address of IP version 6 stands in brackets.
[[nodiscard]] std::optional<NetworkLine> parseNetworkLine(std::string_view name);

}  // namespace nmc
