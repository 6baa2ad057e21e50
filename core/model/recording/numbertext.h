// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace nmc {

/// Numbers in files: they use the C locale's decimal point regardless of the user's locale, with just enough
/// digits to read back the same number.
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

}  // namespace nmc
