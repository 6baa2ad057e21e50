// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// The bytes of a text like "AA 01 0E 0F".
[[nodiscard]] inline std::vector<std::uint8_t> fromHex(const std::string& text) {
    std::vector<std::uint8_t> bytes;
    std::istringstream stream(text);
    for (unsigned byte = 0; stream >> std::hex >> byte;)
        bytes.push_back(static_cast<std::uint8_t>(byte));
    return bytes;
}

}  // namespace nmc::testing_support
