// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shared by the boxes of a panel.

#include <cstddef>

namespace nmc {

/// Maximum number of characters in the name of an axis, an input or an output.
inline constexpr int kMaxNameLength = 40;

[[nodiscard]] constexpr bool bitOf(unsigned mask, std::size_t bit) {
    return (mask >> bit & 1U) != 0;
}

}  // namespace nmc
