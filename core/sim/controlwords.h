// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace nmc::sim {

/// The words of control and fault lines: how they are read, and shown in an error.

[[nodiscard]] inline std::string quoted(std::string_view word) {
    return "'" + std::string(word) + "'";
}

/// The whole word as a number, or nothing.
template <typename T>
[[nodiscard]] std::optional<T> number(std::string_view word) {
    T value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// Two hexadecimal digits, or nothing.
[[nodiscard]] inline std::optional<std::uint8_t> hexByte(std::string_view word) {
    std::uint8_t value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
    if (failure != std::errc{} || end != word.data() + word.size() || word.size() != 2)
        return std::nullopt;
    return value;
}

}  // namespace nmc::sim
