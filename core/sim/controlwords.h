// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
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

}  // namespace nmc::sim
