// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "sim/chain.h"

namespace nmc::sim {

/// Which chips have an input of that name, in that sense.
enum class Chips : std::uint8_t { Both, Servo, Step };

/// What `set N NAME VALUE` can change.
struct InputRow {
    /// A word that stands for a value, or for none.
    struct Word {
        std::string_view text;
        std::optional<double> value;
    };

    std::string_view name;
    Input input;
    Chips chips;
    std::string_view allowed;
    double min;  ///< of numbers; none are allowed when max < min
    double max;
    bool whole;
    std::array<Word, 2> words;
    std::string_view meaning;  ///< with its polarity
};

/// All inputs of all chips; a name comes once for each chip that understands something else by it.
[[nodiscard]] std::span<const InputRow> inputTable();

/// Sets an input by its name; otherwise a sentence that says what is allowed.
[[nodiscard]] tl::expected<void, std::string> setInput(Chain& chain, ModuleIndex module,
                                                       std::string_view name, std::string_view value,
                                                       TimePoint now);

}  // namespace nmc::sim
