// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "base/numbertext.h"
#include "base/time.h"

/// The cells of a CSV line, as written by this program or saved again by a spreadsheet: quoted, with a
/// decimal comma, or with an exponent. For core/model/recording* only; pure.
namespace nmc::cells {

enum class Fault : std::uint8_t { NotANumber, OutOfRange };
struct Bounds {
    double min;
    double max;
    bool eitherSign = false;  ///< the same bounds apply to negative numbers
};
/// Bounds of times relative to the start of a recording, in seconds: ten years.
inline constexpr Bounds kTimes{-315'360'000.0, 315'360'000.0};

/// Splits a line into cells without surrounding spaces and quotes. A separator within quotes does not
/// separate.
void split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Returns what is in quotes, up to the closing quote; text that is not quoted is returned whole.
[[nodiscard]] std::string unquoted(std::string_view text);

/// Reads a whole number within bounds of at most 32 bits.
[[nodiscard]] tl::expected<std::int64_t, Fault> whole(std::string_view cell, Bounds bounds);
/// Reads a number; "nan" means unknown. Infinities are not numbers.
[[nodiscard]] tl::expected<float, Fault> real(std::string_view cell);
[[nodiscard]] tl::expected<double, Fault> real(std::string_view cell, Bounds bounds);
/// Reads seconds, to the nanosecond if there are at most nine decimals and no exponent.
[[nodiscard]] tl::expected<Duration, Fault> time(std::string_view cell);
/// Seconds with nine decimals, exact to the nanosecond.
[[nodiscard]] inline std::string timeText(Duration time) {
    return fixedText(time.count(), 9);
}

}  // namespace nmc::cells
