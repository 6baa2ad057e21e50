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

/// Which chips have an input of that name, in that sense; Both: servos and steppers.
enum class Chips : std::uint8_t { Both, Servo, Stepper, Sc, Io };

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
    unsigned count = 0;        ///< there are so many, and a number stands before the value
};

/// All inputs of all chips; a name comes once for each chip that understands something else by it.
[[nodiscard]] std::span<const InputRow> inputTable();

/// Sets an input; `words` are its name and value, with a number between them where there are several.
/// Otherwise a sentence that says what is allowed.
[[nodiscard]] tl::expected<void, std::string> setInput(Chain& chain, ModuleIndex module,
                                                       std::span<const std::string_view> words,
                                                       TimePoint now);

}  // namespace nmc::sim
