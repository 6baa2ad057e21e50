// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/time.h"

namespace nmc {

/// Rate of every module after power-up, as the data sheets quote it (DS-V 4.1).
inline constexpr std::uint32_t kPowerUpBaud = 19'200;
/// The divisor the chip starts with: 19 531 Bd.
inline constexpr std::uint8_t kPowerUpBrd = 63;

/// The highest rate, that of divisor 0 (DS-V 5.2 Set Baud Rate, 20 MHz).
inline constexpr std::uint32_t kMaxBaud = 1'250'000;

/// One rate that both chips can generate, and the divisor byte of Set Baud for it.
struct BaudRow {
    std::uint32_t nominal;      ///< the rate that the host's port is set to
    std::uint8_t dataSheetBrd;  ///< the data sheets' sample value
    std::uint8_t brd;           ///< the value with the smaller error, which this program sends
};

/// Slowest first. The errors are in protocol.md section 1; 57 600 with code 20 is off by 3.3 %.
inline constexpr std::array<BaudRow, 4> kBaudRows{{
    {9'600, 129, 129},
    {19'200, 63, 64},
    {57'600, 20, 21},
    {115'200, 10, 10},
}};

/// The row for a nominal rate, or nothing when the chips cannot generate it.
[[nodiscard]] std::optional<BaudRow> findBaud(std::uint32_t nominal);

/// The divisor byte for any rate that the chips can generate to within 2 %, half of what a receiver tolerates
/// (protocol.md section 1): the row's divisor where there is a row, otherwise the nearest.
[[nodiscard]] std::optional<std::uint8_t> findBrd(std::uint32_t baud);

/// The rate that the host's port is set to for a divisor: the row's nominal rate where there is a row,
/// otherwise the nearest whole number.
[[nodiscard]] std::uint32_t baudOf(std::uint8_t brd);

/// The rate that a divisor actually generates, in bits per second: 1 250 000 / (brd + 1) (DS-V 5.2 Set Baud
/// Rate, 20 MHz).
[[nodiscard]] double realRate(std::uint8_t brd);

/// Time of one byte (start, 8 data, stop) at a host's rate.
[[nodiscard]] constexpr Duration byteTimeAtBaud(std::uint32_t baud) {
    return Duration(10'000'000'000LL / static_cast<std::int64_t>(baud));
}

}  // namespace nmc
