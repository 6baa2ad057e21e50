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

/// The modules that have an input of that name and meaning.
struct Chips {
    std::string_view word;
    bool (*include)(const ModuleIdentity& module);
};

/// What `set N NAME VALUE` can change.
struct InputRow {
    /// A word that stands for a value, or for no value.
    struct Word {
        std::string_view text;
        std::optional<double> value;
    };

    std::string_view name;
    Input input;
    Chips chips;
    std::string_view allowed;
    double min;  ///< lower bound of numbers; no numbers are allowed when max < min
    double max;
    bool whole;
    std::array<Word, 2> words;
    std::string_view meaning;  ///< including its polarity
    unsigned count = 0;        ///< when not 0, there are this many, and a number precedes the value
};

/// All inputs of all chips; a name appears once for each meaning that it has on some chip.
[[nodiscard]] std::span<const InputRow> inputTable();

/// Sets an input; `words` are its name and value, with a number between them where there are several. The
/// error is a sentence that says what is allowed.
[[nodiscard]] tl::expected<void, std::string> setInput(Chain& chain, ModuleIndex module,
                                                       std::span<const std::string_view> words,
                                                       TimePoint now);

}  // namespace nmc::sim
