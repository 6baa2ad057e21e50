// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/numbertext.h"

namespace nmc::sim {

/// Functions that parse the words of control and fault lines and show them in errors.

[[nodiscard]] inline std::string quoted(std::string_view word) {
    return "'" + std::string(word) + "'";
}

/// Parses two hexadecimal digits; returns nothing for anything else.
[[nodiscard]] inline std::optional<std::uint8_t> hexByte(std::string_view word) {
    return word.size() == 2 ? numberIn<std::uint8_t>(word, 16) : std::nullopt;
}

}  // namespace nmc::sim
