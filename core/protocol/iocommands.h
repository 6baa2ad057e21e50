// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include "base/overloaded.h"
#include "protocol/commanderror.h"
#include "protocol/frame.h"

/// The commands that only a PIC-I/O has (docs/family.md). Of its twelve pins, bit 0 is IO1 and bit 11 IO12.
namespace nmc::io {

inline constexpr unsigned kPins = 12;
inline constexpr int kAnalogInputs = 3;
inline constexpr std::uint16_t kAllPins = 0x0FFF;
/// The timer's clock before its prescaler.
inline constexpr std::uint32_t kTimerHz = 5'000'000;

/// After power-up all pins are inputs.
struct SetDirection {
    std::uint16_t inputs = kAllPins;
    [[nodiscard]] Payload encode() const;
    static tl::expected<SetDirection, CommandError> decode(const Payload& payload);
    bool operator==(const SetDirection&) const = default;
};

/// 0..255 of 19.53 kHz, at once.
struct SetPwm {
    std::uint8_t pwm1 = 0;
    std::uint8_t pwm2 = 0;
    [[nodiscard]] Payload encode() const;
    static tl::expected<SetPwm, CommandError> decode(const Payload& payload);
    bool operator==(const SetPwm&) const = default;
};

/// Puts out what Set Synch Output has stored, in all modules of a group at once. The code of Start Motion.
struct SynchOutput {
    [[nodiscard]] Payload encode() const;
    static tl::expected<SynchOutput, CommandError> decode(const Payload& payload);
    bool operator==(const SynchOutput&) const = default;
};

/// Bits of inputs are ignored.
struct SetOutput {
    std::uint16_t outputs = 0;
    [[nodiscard]] Payload encode() const;
    static tl::expected<SetOutput, CommandError> decode(const Payload& payload);
    bool operator==(const SetOutput&) const = default;
};

/// Stored until Synch Output.
struct SetSynchOutput {
    std::uint16_t outputs = 0;
    std::uint8_t pwm1 = 0;
    std::uint8_t pwm2 = 0;
    [[nodiscard]] Payload encode() const;
    static tl::expected<SetSynchOutput, CommandError> decode(const Payload& payload);
    bool operator==(const SetSynchOutput&) const = default;
};

/// Bits 5, 4 of the mode byte: counts every 1st, 2nd, 4th or 8th.
enum class Prescaler : std::uint8_t { X1 = 0, X2 = 1, X4 = 2, X8 = 3 };
[[nodiscard]] constexpr unsigned divisor(Prescaler prescaler) {
    return 1U << static_cast<unsigned>(prescaler);
}

/// Timer: counts kTimerHz. Counter: counts rising edges of IO10. The count starts at 0.
struct SetTimerMode {
    bool enable = false;
    bool counter = false;
    Prescaler prescaler = Prescaler::X1;
    [[nodiscard]] Payload encode() const;
    static tl::expected<SetTimerMode, CommandError> decode(const Payload& payload);
    bool operator==(const SetTimerMode&) const = default;
};

/// Latches inputs and counter, in all modules of a group at once. The code of Save as Home.
struct SynchInput {
    [[nodiscard]] Payload encode() const;
    static tl::expected<SynchInput, CommandError> decode(const Payload& payload);
    bool operator==(const SynchInput&) const = default;
};

/// A command that no other chip knows.
template <typename T>
concept OwnCommand =
    AnyOf<T, SetDirection, SetPwm, SynchOutput, SetOutput, SetSynchOutput, SetTimerMode, SynchInput>;

}  // namespace nmc::io
