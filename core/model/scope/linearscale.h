// SPDX-License-Identifier: MIT
#pragma once

namespace nmc {

/// Converts counts to the values that are drawn.
struct LinearScale {
    double factor = 1;
    double offset = 0;
    [[nodiscard]] double operator()(double counts) const { return counts * factor + offset; }
    bool operator==(const LinearScale&) const = default;
};

}  // namespace nmc
