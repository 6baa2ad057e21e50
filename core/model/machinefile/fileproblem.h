// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace nmc {

/// Why a machine file was not read. Data only; the sentences are in widgets/common/machinetexts.cpp.
struct FileProblem {
    enum class Kind : std::uint8_t {
        Empty,
        TooLarge,   ///< `max` bytes are read
        Truncated,  ///< it ends where it must not
        NotUtf8,
        NotJson,
        NotANumber,       ///< NaN or an infinity, in `found`
        NumberTooBig,     ///< for any computer's numbers
        TooDeep,          ///< `max` levels
        TooManyValues,    ///< `max` in all
        DuplicateKey,     ///< `field` is there twice in one object
        OtherFormat,      ///< it does not say that it is a machine file
        NewerVersion,     ///< `found` is its version, `max` the newest this program knows
        Missing,          ///< `field`, in the object that begins at the line
        WrongType,        ///< `field` is not a `wanted`
        OutOfRange,       ///< `field` is `found`; `min` to `max`
        UnknownWord,      ///< `field` is `found`, which is none of its words
        UnprintableText,  ///< `field` has a control character in it
        TooMany,          ///< `field` has more than `max` entries
        OtherChip,        ///< `field` has a unit that the axis' module does not have
        ModuleTwice,      ///< module `found` is in two groups, or twice in one
        AddressTwice,     ///< two groups have address `found`
        LeaderNotInGroup,
        // Of points and sequences
        NameMissing,     ///< of one of `field`
        NameTwice,       ///< two of `field` are called `found`
        AxisTwice,       ///< module `found` is twice in `field`
        NoSuchPoint,     ///< a row moves to point `found`
        NoSuchSequence,  ///< a row calls sequence `found`
        CallsItself,     ///< sequence `found`, here or through others
        RepeatsBelow,    ///< a row goes back to itself or to a row below
    };
    enum class Wanted : std::uint8_t { WholeNumber, Number, Text, YesOrNo, Object, List };

    Kind kind = Kind::Empty;
    int line = 1;         ///< from 1
    std::string field{};  ///< the key, as it stands in the file
    std::string found{};  ///< what stands there; long texts are cut
    Wanted wanted = Wanted::WholeNumber;
    double min = 0.0;
    double max = 0.0;
    bool ofModule = false;  ///< the range is what the module takes

    bool operator==(const FileProblem&) const = default;
};

}  // namespace nmc
