// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>

#include "model/scope/scopesample.h"

namespace nmc {

/// The signals that the scope draws as curves.
enum class ScopeSignal : std::uint8_t {
    Position,
    Command,  ///< calculated command position
    Error,    ///< calculated position error
    Velocity,
    Analog,        ///< A/D: motor current where the sense resistor is fitted (DS-V 3); A/D 1 of a PIC-I/O
    Acceleration,  ///< from positions
    Pwm,           ///< calculated: the control filter's output for the calculated error (DS-V 4.3)
    // PIC-I/O (docs/family.md)
    Analog2,
    Analog3,
    Counter,  ///< or timer
    CountRate
};

inline constexpr std::size_t kScopeSignals = 11;

/// True for signals calculated from the commands sent, because the chip does not report them; they are
/// sometimes unknown.
[[nodiscard]] constexpr bool isCalculated(ScopeSignal signal) {
    return signal == ScopeSignal::Command || signal == ScopeSignal::Error || signal == ScopeSignal::Pwm;
}

/// True for signals that no sample contains: they are computed from several samples, only while they are
/// displayed (DerivedSignals).
[[nodiscard]] constexpr bool isDerived(ScopeSignal signal) {
    return signal == ScopeSignal::Acceleration || signal == ScopeSignal::Pwm ||
           signal == ScopeSignal::CountRate;
}

/// True for signals that only a PIC-I/O has; of the others it has only Analog.
[[nodiscard]] constexpr bool isOfIo(ScopeSignal signal) {
    return signal >= ScopeSignal::Analog2;
}

/// The index of the PIC-I/O's A/D input from 0, or nothing for another signal.
[[nodiscard]] constexpr std::optional<std::size_t> analogInputOf(ScopeSignal signal) {
    switch (signal) {
        case ScopeSignal::Analog:
            return 0;
        case ScopeSignal::Analog2:
            return 1;
        case ScopeSignal::Analog3:
            return 2;
        case ScopeSignal::Position:
        case ScopeSignal::Command:
        case ScopeSignal::Error:
        case ScopeSignal::Velocity:
        case ScopeSignal::Acceleration:
        case ScopeSignal::Pwm:
        case ScopeSignal::Counter:
        case ScopeSignal::CountRate:
            break;
    }
    return std::nullopt;
}

/// The value in counts, counts/s or A/D counts; nothing if it is unknown or derived. The sample's module must
/// have this signal.
[[nodiscard]] inline std::optional<double> valueOf(const ScopeSample& sample, ScopeSignal signal) {
    double value = 0;
    switch (signal) {
        case ScopeSignal::Position:
            value = sample.position;
            break;
        case ScopeSignal::Command:
            value = sample.command();
            break;
        case ScopeSignal::Error:
        case ScopeSignal::Analog2:
            value = static_cast<double>(sample.error);
            break;
        case ScopeSignal::Velocity:
        case ScopeSignal::Analog3:
            value = static_cast<double>(sample.velocity);
            break;
        case ScopeSignal::Counter:
            value = sample.counter();
            break;
        case ScopeSignal::Analog:
            value = sample.analog;
            break;
        case ScopeSignal::Acceleration:
        case ScopeSignal::Pwm:
        case ScopeSignal::CountRate:
            return std::nullopt;
    }
    if (std::isnan(value))
        return std::nullopt;
    return value;
}

/// One bit of a module's status (DS-V 5.3, DS-S 5.2), or a pin of a PIC-I/O.
struct ScopeBit {
    /// Aux is the second byte: the auxiliary status, or the inputs of a PIC-STEP. On a PIC-I/O, Status is IO1
    /// to IO8 and Aux IO9 to IO12.
    enum class Byte : std::uint8_t { Status, Aux };
    Byte byte = Byte::Status;
    std::uint8_t bit = 0;  ///< 0..7

    auto operator<=>(const ScopeBit&) const = default;
};

[[nodiscard]] constexpr bool isSet(const ScopeSample& sample, ScopeBit bit) {
    const unsigned byte = bit.byte == ScopeBit::Byte::Status ? sample.status : sample.aux;
    return ((byte >> (bit.bit & 7U)) & 1U) != 0;
}

}  // namespace nmc
