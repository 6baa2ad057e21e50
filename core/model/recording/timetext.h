// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/numbertext.h"
#include "base/time.h"

namespace nmc {

/// Appends seconds with nine decimals, exact to the nanosecond.
inline void appendTime(std::string& out, Duration time) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t ns = time.count();
    if (ns < 0)
        out += '-';
    appendNumber(out, std::abs(ns / kSecond));
    std::array<char, 10> fraction{'.'};
    std::int64_t rest = std::abs(ns % kSecond);
    for (std::size_t i = fraction.size() - 1; i > 0; --i, rest /= 10)
        fraction[i] = static_cast<char>('0' + rest % 10);
    out.append(fraction.data(), fraction.size());
}

}  // namespace nmc
