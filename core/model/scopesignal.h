// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "model/scopesample.h"

namespace nmc {

/// What the scope draws as a line.
enum class ScopeSignal : std::uint8_t { Position, Command, Error, Velocity, Analog };

/// In counts, counts/s or A/D steps; nothing where it is not known.
[[nodiscard]] inline std::optional<double> valueOf(const ScopeSample& sample, ScopeSignal signal) {
    const auto known = [](double value) { return std::isnan(value) ? std::nullopt : std::optional(value); };
    switch (signal) {
        case ScopeSignal::Position:
            return sample.position;
        case ScopeSignal::Command:
            return known(sample.command());
        case ScopeSignal::Error:
            return known(static_cast<double>(sample.error));
        case ScopeSignal::Velocity:
            return known(static_cast<double>(sample.velocity));
        case ScopeSignal::Analog:
            return sample.analog;
    }
    return std::nullopt;
}

/// One bit of what the module says of itself (DS-V 5.3, DS-S 5.2).
struct ScopeBit {
    enum class Byte : std::uint8_t { Status, Aux };
    Byte byte = Byte::Status;
    std::uint8_t bit = 0;  ///< 0..7

    bool operator==(const ScopeBit&) const = default;
};

[[nodiscard]] constexpr bool isSet(const ScopeSample& sample, ScopeBit bit) {
    const unsigned byte = bit.byte == ScopeBit::Byte::Status ? sample.status : sample.aux;
    return ((byte >> (bit.bit & 7U)) & 1U) != 0;
}

}  // namespace nmc
