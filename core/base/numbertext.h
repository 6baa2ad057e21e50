// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace nmc {

// Numbers in files and commands: they use the C locale's decimal point regardless of the user's locale.

/// Appends just enough digits to read back the same number.
template <typename Number>
void appendNumber(std::string& out, Number number) {
    std::array<char, 32> digits;
    out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

template <typename Number>
[[nodiscard]] std::string textOf(Number number) {
    std::string text;
    appendNumber(text, number);
    return text;
}

/// The number with the point before its last `decimals` digits: 1500 with three decimals is 1.500.
[[nodiscard]] inline std::string fixedText(std::int64_t number, std::size_t decimals) {
    std::string text = textOf(std::abs(number));
    if (text.size() <= decimals)
        text.insert(0, decimals + 1 - text.size(), '0');
    text.insert(text.size() - decimals, 1, '.');
    return number < 0 ? '-' + text : text;
}

/// Reads the whole text as a number; returns nothing if it is anything else. `how`: the last argument of
/// std::from_chars(), such as the base.
template <typename Number>
[[nodiscard]] std::optional<Number> numberIn(std::string_view text, auto... how) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data(), end, number, how...);
    return error == std::errc{} && next == end ? std::optional(number) : std::nullopt;
}

}  // namespace nmc
