// SPDX-License-Identifier: MIT
#pragma once

// For describe.cpp only.

#include <string>
#include <string_view>

namespace nmc::describe {

/// A list of phrases joined by a separator.
class Phrases {
public:
    explicit Phrases(std::string_view separator = ", ") : m_separator(separator) {}

    Phrases& add(std::string_view phrase) {
        if (!m_text.empty())
            m_text += m_separator;
        m_text += phrase;
        return *this;
    }
    Phrases& addIf(bool condition, std::string_view phrase) { return condition ? add(phrase) : *this; }
    [[nodiscard]] bool empty() const { return m_text.empty(); }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
    std::string_view m_separator;
};

/// Returns "1 null" or "16 nulls", for example.
[[nodiscard]] inline std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + ' ' + std::string(thing) + (count == 1 ? "" : "s");
}

/// Returns the names of the lines whose bits are set, for example "IO1 IO12".
[[nodiscard]] inline std::string lineNames(std::string_view name, unsigned count, unsigned bits,
                                           std::string_view none) {
    Phrases phrases(" ");
    for (unsigned line = 0; line < count; ++line)
        phrases.addIf((bits >> line & 1U) != 0, std::string(name) + std::to_string(line + 1));
    return phrases.empty() ? std::string(none) : phrases.text();
}

}  // namespace nmc::describe
