// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace nmc::sim {

/// Functions that parse the words of control and fault lines and show them in errors.

[[nodiscard]] inline std::string quoted(std::string_view word) {
    return "'" + std::string(word) + "'";
}

/// Parses the whole word as a number; returns nothing if it is not one.
template <typename T>
[[nodiscard]] std::optional<T> number(std::string_view word) {
    T value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// Parses two hexadecimal digits; returns nothing for anything else.
[[nodiscard]] inline std::optional<std::uint8_t> hexByte(std::string_view word) {
    std::uint8_t value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
    if (failure != std::errc{} || end != word.data() + word.size() || word.size() != 2)
        return std::nullopt;
    return value;
}

}  // namespace nmc::sim
