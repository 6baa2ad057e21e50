// SPDX-License-Identifier: MIT
#include "protocol/baud.h"

namespace nmc {

std::optional<BaudRow> findBaud(std::uint32_t nominal) {
    for (const BaudRow& row : kBaudRows)
        if (row.nominal == nominal)
            return row;
    return std::nullopt;
}

double realRate(std::uint8_t brd) {
    return 1'250'000.0 / (brd + 1);
}

}  // namespace nmc
