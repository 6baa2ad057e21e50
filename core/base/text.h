// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace nmc {

/// Returns `text` without leading and trailing blanks.
[[nodiscard]] inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
    const auto first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Returns `text` with the letters of ASCII in lower case.
[[nodiscard]] inline std::string lowered(std::string_view text) {
    std::string key(text);
    std::ranges::transform(key, key.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return key;
}

/// True for a control character of ASCII.
[[nodiscard]] inline bool isControl(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == '\x7F';
}

/// Returns the first `most` bytes of `text` as a single line of a file: line ends and other control
/// characters, which the name of a port or a module may contain, become '?'.
[[nodiscard]] inline std::string oneLine(std::string_view text, std::size_t most) {
    std::string line(text.substr(0, most));
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return line;
}

}  // namespace nmc
