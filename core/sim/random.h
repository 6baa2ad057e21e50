// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace nmc::sim {

/// The simulator's only source of randomness: SplitMix64. The standard's distributions differ between
/// libraries, and a seed must give the same history everywhere.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        m_state += 0x9E37'79B9'7F4A'7C15U;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xBF58'476D'1CE4'E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D0'49BB'1331'11EBU;
        return z ^ (z >> 31U);
    }

    /// 0 <= result < limit. The bias of the remainder is below 1e-12 for the small limits used here.
    std::uint64_t below(std::uint64_t limit) { return next() % limit; }

    /// 0 <= result < 1.
    double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

    /// Normally distributed with mean 0 and standard deviation 1 (Box and Muller).
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
        return radius * std::cos(2.0 * std::numbers::pi * unit());
    }

private:
    std::uint64_t m_state;
};

}  // namespace nmc::sim
