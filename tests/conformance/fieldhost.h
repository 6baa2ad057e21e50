// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

/// What the host programs of the field have in common.
namespace nmc::field {

using Bytes = std::vector<std::uint8_t>;
using Clock = std::chrono::steady_clock;

inline constexpr std::chrono::seconds kPatience{20};
inline constexpr unsigned kEveryone = 0xFF;

[[nodiscard]] inline Bytes operator+(Bytes left, const Bytes& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

}  // namespace nmc::field
