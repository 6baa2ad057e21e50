// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/strong.h"
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
    CountRate,
    // Defined by the user (CustomSignal)
    Custom1,
    Custom2,
    Custom3,
    Custom4
};
inline constexpr std::size_t kCustomSignals = 4;

/// A signal of a module.
struct ModuleSignal {
    ModuleIndex module;
    ScopeSignal signal = ScopeSignal::Position;
    bool operator==(const ModuleSignal&) const = default;
};

/// What is known of a signal. Its name is in widgets/scope/scopewords.cpp, and how it is computed, if it is
/// derived, in DerivedSignals or CustomSignal.
struct SignalInfo {
    /// The part of a sample that contains it.
    enum class Place : std::uint8_t {
        Derived,  ///< none: it is computed from several samples, only while it is displayed (DerivedSignals)
        Position,
        Counter,  ///< the position of a PIC-I/O's sample, with 2^31 added
        Command,
        Error,
        Velocity,
        Analog
    };
    /// What its values are multiples of.
    enum class Unit : std::uint8_t {
        Position,
        Velocity,
        Acceleration,
        Analog,  ///< that of the A/D input
        Pwm,     ///< of 255
        Count,
        CountRate,
        Custom  ///< named by the user
    };
    enum class Owner : std::uint8_t { Motor, Io, Both };

    ScopeSignal signal;
    std::string_view word;  ///< in settings: never translated, never changed
    Place place;
    Unit unit;
    Owner owner = Owner::Motor;
    /// Calculated from the commands sent, because the chip does not report it; sometimes unknown.
    bool calculated = false;
    /// The index of the PIC-I/O's A/D input from 0.
    std::optional<std::size_t> analogInput{};
};

/// One row for each signal, in their order.
inline constexpr auto kSignals = [] {
    using enum SignalInfo::Owner;
    using Place = SignalInfo::Place;
    using Unit = SignalInfo::Unit;
    return std::array{
        SignalInfo{ScopeSignal::Position, "position", Place::Position, Unit::Position},
        SignalInfo{ScopeSignal::Command, "command", Place::Command, Unit::Position, Motor, true},
        SignalInfo{ScopeSignal::Error, "error", Place::Error, Unit::Position, Motor, true},
        SignalInfo{ScopeSignal::Velocity, "velocity", Place::Velocity, Unit::Velocity},
        SignalInfo{ScopeSignal::Analog, "analog", Place::Analog, Unit::Analog, Both, false, 0},
        SignalInfo{ScopeSignal::Acceleration, "acceleration", Place::Derived, Unit::Acceleration},
        SignalInfo{ScopeSignal::Pwm, "pwm", Place::Derived, Unit::Pwm, Motor, true},
        SignalInfo{ScopeSignal::Analog2, "analog2", Place::Error, Unit::Analog, Io, false, 1},
        SignalInfo{ScopeSignal::Analog3, "analog3", Place::Velocity, Unit::Analog, Io, false, 2},
        SignalInfo{ScopeSignal::Counter, "counter", Place::Counter, Unit::Count, Io},
        SignalInfo{ScopeSignal::CountRate, "rate", Place::Derived, Unit::CountRate, Io},
        SignalInfo{ScopeSignal::Custom1, "custom1", Place::Derived, Unit::Custom, Both},
        SignalInfo{ScopeSignal::Custom2, "custom2", Place::Derived, Unit::Custom, Both},
        SignalInfo{ScopeSignal::Custom3, "custom3", Place::Derived, Unit::Custom, Both},
        SignalInfo{ScopeSignal::Custom4, "custom4", Place::Derived, Unit::Custom, Both},
    };
}();

[[nodiscard]] constexpr const SignalInfo& infoOf(ScopeSignal signal) {
    return kSignals[static_cast<std::size_t>(signal)];
}

static_assert([] {
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        if (kSignals[i].signal != static_cast<ScopeSignal>(i))
            return false;
    return kSignals.back().signal == ScopeSignal::Custom4;
}());

[[nodiscard]] constexpr bool isDerived(ScopeSignal signal) {
    return infoOf(signal).place == SignalInfo::Place::Derived;
}

/// Which of the user's signals it is, from 0; nothing for any other.
[[nodiscard]] constexpr std::optional<std::size_t> customIndex(ScopeSignal signal) {
    if (signal < ScopeSignal::Custom1)
        return std::nullopt;
    return static_cast<std::size_t>(signal) - static_cast<std::size_t>(ScopeSignal::Custom1);
}

/// The user's signal with this index.
[[nodiscard]] constexpr ScopeSignal customSignal(std::size_t index) {
    return static_cast<ScopeSignal>(static_cast<std::size_t>(ScopeSignal::Custom1) + index);
}

/// The value in counts, counts/s or A/D counts; nothing if it is unknown or derived. The sample's module must
/// have this signal.
[[nodiscard]] inline std::optional<double> valueOf(const ScopeSample& sample, ScopeSignal signal) {
    double value = 0;
    switch (infoOf(signal).place) {
        case SignalInfo::Place::Derived:
            return std::nullopt;
        case SignalInfo::Place::Position:
            value = sample.position;
            break;
        case SignalInfo::Place::Counter:
            value = sample.counter();
            break;
        case SignalInfo::Place::Command:
            value = sample.command();
            break;
        case SignalInfo::Place::Error:
            value = static_cast<double>(sample.error);
            break;
        case SignalInfo::Place::Velocity:
            value = static_cast<double>(sample.velocity);
            break;
        case SignalInfo::Place::Analog:
            value = sample.analog;
            break;
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

    /// In the word of both bytes, with the status in the low one; of a PIC-I/O, the pin, from 0.
    [[nodiscard]] constexpr unsigned number() const { return bit + (byte == Byte::Aux ? 8U : 0U); }
    auto operator<=>(const ScopeBit&) const = default;
};

[[nodiscard]] constexpr bool isSet(const ScopeSample& sample, ScopeBit bit) {
    const unsigned byte = bit.byte == ScopeBit::Byte::Status ? sample.status : sample.aux;
    return ((byte >> (bit.bit & 7U)) & 1U) != 0;
}

}  // namespace nmc
