// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/time.h"

/// The cells of a CSV line, as this program writes them or as a spreadsheet has saved them again: quoted,
/// with a comma for the decimal point, with an exponent. For core/model/recording* only; pure.
namespace nmc::cells {

enum class Fault : std::uint8_t { NotANumber, OutOfRange };
struct Bounds {
    double min;
    double max;
    bool eitherSign = false;  ///< the same below 0
};
/// Of times from the start of a recording, in seconds: ten years.
inline constexpr Bounds kTimes{-315'360'000.0, 315'360'000.0};

/// Without spaces and quotes around them. A separator within quotes does not separate.
void split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// What was in quotes, up to their end; all of what was not.
[[nodiscard]] std::string unquoted(std::string_view text);

/// Whole, within the bounds, which are those of at most 32 bits.
[[nodiscard]] tl::expected<std::int64_t, Fault> whole(std::string_view cell, Bounds bounds);
/// "nan" is what is not known. Infinities are no numbers.
[[nodiscard]] tl::expected<float, Fault> real(std::string_view cell);
[[nodiscard]] tl::expected<double, Fault> real(std::string_view cell, Bounds bounds);
/// Seconds; to the nanosecond where it has up to nine decimals and no exponent.
[[nodiscard]] tl::expected<Duration, Fault> time(std::string_view cell);

}  // namespace nmc::cells
