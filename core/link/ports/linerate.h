// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace nmc {

/// The rate that the driver of an open terminal has really set, in bits per second, where it tells. Drivers
/// round what was asked for to what their divisor makes.
[[nodiscard]] std::optional<std::uint32_t> lineRate(int fd);

/// Sets any rate at all, at once, and nothing else of the terminal's settings. A signal handler may do so.
bool setLineRate(int fd, std::uint32_t baud);

/// A mismatch of more than 2 % between two ends uses up half of what a receiver bears (protocol.md 1).
[[nodiscard]] bool rateIsGoodEnough(std::uint32_t wanted, std::uint32_t real);

}  // namespace nmc
