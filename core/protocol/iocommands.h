// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/overloaded.h"
#include "protocol/commandform.h"

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
    static constexpr CommandCode kCode = CommandCode::ResetPosition;
    static void fields(auto& form, auto& c) { form.lines("inputs", "IO", kPins, c.inputs); }
    bool operator==(const SetDirection&) const = default;
};

/// 0..255 of 19.53 kHz, at once.
struct SetPwm {
    std::uint8_t pwm1 = 0;
    std::uint8_t pwm2 = 0;
    static constexpr CommandCode kCode = CommandCode::LoadTrajectory;
    static void fields(auto& form, auto& c) {
        form.number("PWM1", c.pwm1);
        form.number("PWM2", c.pwm2);
    }
    bool operator==(const SetPwm&) const = default;
};

/// Puts out what Set Synch Output has stored, in all modules of a group at once. The code of Start Motion.
struct SynchOutput {
    static constexpr CommandCode kCode = CommandCode::StartMotion;
    static void fields(auto& /*form*/, auto& /*c*/) {}
    bool operator==(const SynchOutput&) const = default;
};

/// Bits of inputs are ignored.
struct SetOutput {
    std::uint16_t outputs = 0;
    static constexpr CommandCode kCode = CommandCode::SetGain;
    static void fields(auto& form, auto& c) { form.lines("high", "IO", kPins, c.outputs); }
    bool operator==(const SetOutput&) const = default;
};

/// Stored until Synch Output.
struct SetSynchOutput {
    std::uint16_t outputs = 0;
    std::uint8_t pwm1 = 0;
    std::uint8_t pwm2 = 0;
    static constexpr CommandCode kCode = CommandCode::StopMotor;
    static void fields(auto& form, auto& c) {
        form.lines("high", "IO", kPins, c.outputs);
        form.number("PWM1", c.pwm1);
        form.number("PWM2", c.pwm2);
    }
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
    static constexpr CommandCode kCode = CommandCode::IoControl;
    static void fields(auto& form, auto& c) {
        form.bit(0, c.enable);
        form.bit(1, c.counter);
        form.say(!c.enable ? "off" : c.counter ? "counter" : "timer");
        form.choice(0x30, c.prescaler,
                    {{Prescaler::X1, 0x00, c.enable ? "prescaler 1" : ""},
                     {Prescaler::X2, 0x10, c.enable ? "prescaler 2" : ""},
                     {Prescaler::X4, 0x20, c.enable ? "prescaler 4" : ""},
                     {Prescaler::X8, 0x30, c.enable ? "prescaler 8" : ""}});
    }
    bool operator==(const SetTimerMode&) const = default;
};

/// Latches inputs and counter, in all modules of a group at once. The code of Save as Home.
struct SynchInput {
    static constexpr CommandCode kCode = CommandCode::SaveAsHome;
    static void fields(auto& /*form*/, auto& /*c*/) {}
    bool operator==(const SynchInput&) const = default;
};

/// A command that no other chip knows.
template <typename T>
concept OwnCommand =
    AnyOf<T, SetDirection, SetPwm, SynchOutput, SetOutput, SetSynchOutput, SetTimerMode, SynchInput>;

}  // namespace nmc::io
