// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace nmc {

/// The rate that the driver of an open terminal has actually set, in bits per second, where it reports it.
/// Drivers round the requested rate to what their divisor can generate.
[[nodiscard]] std::optional<std::uint32_t> lineRate(int fd);

/// Sets any rate, immediately, without changing the terminal's other settings. A signal handler may call it.
bool setLineRate(int fd, std::uint32_t baud);

/// A mismatch of more than 2 % between two ends uses up half of what a receiver tolerates (protocol.md 1).
[[nodiscard]] bool rateIsGoodEnough(std::uint32_t wanted, std::uint32_t real);

}  // namespace nmc
