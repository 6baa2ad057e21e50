// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace nmc {

/// Why a machine file could not be read. Data only; the sentences are in widgets/common/machinetexts.cpp.
struct FileProblem {
    enum class Kind : std::uint8_t {
        Empty,
        TooLarge,   ///< at most `max` bytes are read
        Truncated,  ///< the file ends prematurely
        NotUtf8,
        NotJson,
        NotANumber,       ///< NaN or infinity, in `found`
        NumberTooBig,     ///< exceeds the range of floating-point numbers
        TooDeep,          ///< more than `max` levels
        TooManyValues,    ///< more than `max` in total
        DuplicateKey,     ///< `field` occurs twice in one object
        OtherFormat,      ///< the file does not identify itself as a machine file
        NewerVersion,     ///< the file has version `found`; `max` is the newest supported
        Missing,          ///< `field` is missing in the object that begins at the line
        WrongType,        ///< `field` is not a `wanted`
        OutOfRange,       ///< `field` is `found`, but must be `min` to `max`
        UnknownWord,      ///< `field` is `found`, which is not one of its words
        UnprintableText,  ///< `field` contains a control character
        TooMany,          ///< `field` has more than `max` entries
        OtherChip,        ///< `field` has a unit that the axis's module does not use
        ModuleTwice,      ///< module `found` is in two groups, or twice in one
        AddressTwice,     ///< two groups have address `found`
        LeaderNotInGroup,
        LimitsCrossed,  ///< the lowest position is not below the highest
        // Points and sequences
        NameMissing,     ///< an item of `field` has no name
        NameTwice,       ///< two items of `field` are named `found`
        AxisTwice,       ///< module `found` occurs twice in `field`
        NoSuchPoint,     ///< a row moves to point `found`
        NoSuchSequence,  ///< a row calls sequence `found`
        CallsItself,     ///< sequence `found`, directly or through others
        RepeatsBelow,    ///< a row goes back to itself or to a later row
    };
    enum class Wanted : std::uint8_t { WholeNumber, Number, Text, YesOrNo, Object, List };

    Kind kind = Kind::Empty;
    int line = 1;         ///< from 1
    std::string field{};  ///< the key as in the file
    std::string found{};  ///< the value in the file; long texts are cut
    Wanted wanted = Wanted::WholeNumber;
    double min = 0.0;
    double max = 0.0;
    bool ofModule = false;  ///< the range is that of the module

    bool operator==(const FileProblem&) const = default;
};

}  // namespace nmc
