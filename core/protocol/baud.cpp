// SPDX-License-Identifier: MIT
#include "protocol/baud.h"

#include <algorithm>
#include <cmath>

namespace nmc {

std::optional<BaudRow> findBaud(std::uint32_t nominal) {
    for (const BaudRow& row : kBaudRows)
        if (row.nominal == nominal)
            return row;
    return std::nullopt;
}

std::optional<std::uint8_t> findBrd(std::uint32_t baud) {
    if (const auto row = findBaud(baud))
        return row->brd;
    constexpr double kHarmless = 0.02;
    const double divisor = realRate(0) / std::max(baud, 1U);
    const auto brd = static_cast<std::uint8_t>(std::clamp(std::round(divisor) - 1, 0.0, 255.0));
    if (std::abs(realRate(brd) / std::max(baud, 1U) - 1) > kHarmless)
        return std::nullopt;
    return brd;
}

std::uint32_t baudOf(std::uint8_t brd) {
    for (const BaudRow& row : kBaudRows)
        if (row.brd == brd)
            return row.nominal;
    return static_cast<std::uint32_t>(std::lround(realRate(brd)));
}

double realRate(std::uint8_t brd) {
    return static_cast<double>(kMaxBaud) / (brd + 1);
}

}  // namespace nmc
