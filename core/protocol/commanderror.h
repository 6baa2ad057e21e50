// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// Why a payload could not be decoded as the requested command.
enum class CommandError : std::uint8_t {
    WrongCode,
    Length,      ///< the control byte, or the command, calls for a different number of data bytes
    OutOfRange,  ///< a value outside the data sheet's range
};

/// An inclusive range from a data sheet.
struct ValueRange {
    std::int64_t min;
    std::int64_t max;
    [[nodiscard]] constexpr bool contains(std::int64_t value) const { return value >= min && value <= max; }
};

}  // namespace nmc
