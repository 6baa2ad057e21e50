// SPDX-License-Identifier: MIT
#include "link/ports/networkline.h"

#include <algorithm>

#include "base/numbertext.h"
#include "base/text.h"

namespace nmc {

namespace {

constexpr std::string_view kRaw = "tcp://";
constexpr std::string_view kRfc2217 = "rfc2217://";

[[nodiscard]] bool belongsToHost(char c) {
    return !isControl(c) && std::string_view(" /@?#[]").find(c) == std::string_view::npos;
}

}  // namespace

bool isNetworkName(std::string_view name) {
    return name.starts_with(kRaw) || name.starts_with(kRfc2217);
}

std::optional<NetworkLine> parseNetworkLine(std::string_view name) {
    if (!isNetworkName(name))
        return std::nullopt;
    NetworkLine line;
    line.protocol = name.starts_with(kRaw) ? NetworkLine::Protocol::Raw : NetworkLine::Protocol::Rfc2217;
    name.remove_prefix(line.protocol == NetworkLine::Protocol::Raw ? kRaw.size() : kRfc2217.size());
    const auto colon = name.rfind(':');
    if (colon == std::string_view::npos)
        return std::nullopt;
    std::string_view host = name.substr(0, colon);
    const std::string_view port = name.substr(colon + 1);
    const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (bracketed)
        host = host.substr(1, host.size() - 2);
    // Without brackets, it is unclear where an address with colons ends.
    if (host.empty() || !std::ranges::all_of(host, belongsToHost) ||
        bracketed != (host.find(':') != std::string_view::npos))
        return std::nullopt;
    line.host = host;
    line.port = numberIn<std::uint16_t>(port).value_or(0);
    return line.port != 0 ? std::optional(line) : std::nullopt;
}

}  // namespace nmc
