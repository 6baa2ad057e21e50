// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "model/machinefile/fileproblem.h"

namespace nmc {

/// A JSON value that knows its line, so that whatever is wrong with it can be found again.
struct JsonValue {
    enum class Kind : std::uint8_t { Null, Flag, Number, Text, List, Object };
    Kind kind = Kind::Null;
    int line = 1;  ///< where it stands; of a list or an object, where it begins
    bool flag = false;
    double number = 0.0;
    std::string text;
    std::vector<std::string> keys;  ///< of an object: those of `items`
    std::vector<JsonValue> items;

    JsonValue() = default;
    JsonValue(Kind ofKind, int atLine) : kind(ofKind), line(atLine) {}
    /// Of an object; null where there is none.
    [[nodiscard]] const JsonValue* find(std::string_view key) const;
};

inline constexpr int kMaxJsonDepth = 32;
inline constexpr int kMaxJsonValues = 50'000;

/// The whole text is one JSON value, its keys differ within an object, and it keeps the limits above.
/// The caller has limited its size.
[[nodiscard]] tl::expected<JsonValue, FileProblem> parseJson(std::string_view text);

}  // namespace nmc
