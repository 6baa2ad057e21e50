// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "model/machinefile/fileproblem.h"

namespace nmc {

/// A JSON value that knows its line, so that any problem with it can be located.
struct JsonValue {
    enum class Kind : std::uint8_t { Null, Flag, Number, Text, List, Object };
    Kind kind = Kind::Null;
    int line = 1;  ///< line of the value; for a list or object, its first line
    bool flag = false;
    double number = 0.0;
    std::string text{};
    std::vector<std::string> keys{};  ///< for an object: the keys of `items`
    std::vector<JsonValue> items{};

    /// For an object; returns null if it has no such key.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

inline constexpr int kMaxJsonDepth = 32;
inline constexpr int kMaxJsonValues = 50'000;

/// Parses text that consists of a single JSON value, with unique keys within each object, and within the
/// limits above. The caller limits its size.
[[nodiscard]] tl::expected<JsonValue, FileProblem> parseJson(std::string_view text);

}  // namespace nmc
