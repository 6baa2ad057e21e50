// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "model/packets/packetlog.h"

namespace nmc {

struct PacketFile {
    PacketSession session;
    std::uint64_t dropped = 0;
    std::vector<PacketEntry> entries;  ///< numbered from 1
};

inline constexpr std::size_t kMaxPacketFile = 16U << 20U;  ///< bytes; a full PacketLog fits
inline constexpr std::size_t kMaxPacketLine = 20'000;      ///< bytes

/// Reads what writePacketFile() writes and nothing else, according to the description of the format
/// (model/packets/packetfile.h); session.zero is TimePoint{}. The error is a sentence that names the line:
/// "Line 12: the reply is not hexadecimal."
[[nodiscard]] tl::expected<PacketFile, std::string> parsePacketFile(std::string_view text);

}  // namespace nmc
