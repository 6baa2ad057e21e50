// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/overloaded.h"
#include "protocol/commandform.h"

/// The commands that only a PIC-I/O has (docs/family.md). In masks of its twelve pins, bit 0 is IO1 and bit
/// 11 is IO12.
namespace nmc::io {

inline constexpr unsigned kPins = 12;
inline constexpr int kAnalogInputs = 3;
inline constexpr std::uint16_t kAllPins = 0x0FFF;
/// The timer's clock frequency before the prescaler.
inline constexpr std::uint32_t kTimerHz = 5'000'000;

/// Selects which pins are inputs; after power-up all of them are.
struct SetDirection {
    std::uint16_t inputs = kAllPins;
    static constexpr CommandCode kCode = CommandCode::ResetPosition;
    static void fields(auto& form, auto& c) { form.lines("inputs", "IO", kPins, c.inputs); }
    bool operator==(const SetDirection&) const = default;
};

/// Duty cycles, 0..255, of the 19.53 kHz PWM outputs; they take effect immediately.
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

/// Outputs the values stored by Set Synch Output, in all modules of a group at once. It has the code of Start
/// Motion.
struct SynchOutput : CommandWithoutData<CommandCode::StartMotion> {};

/// Sets the output pins; the bits of input pins are ignored.
struct SetOutput {
    std::uint16_t outputs = 0;
    static constexpr CommandCode kCode = CommandCode::SetGain;
    static void fields(auto& form, auto& c) { form.lines("high", "IO", kPins, c.outputs); }
    bool operator==(const SetOutput&) const = default;
};

/// Stores output values until Synch Output applies them.
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

/// Bits 5, 4 of the mode byte: every 1st, 2nd, 4th or 8th pulse is counted.
enum class Prescaler : std::uint8_t { X1 = 0, X2 = 1, X4 = 2, X8 = 3 };
[[nodiscard]] constexpr unsigned divisor(Prescaler prescaler) {
    return 1U << static_cast<unsigned>(prescaler);
}

/// A timer counts at kTimerHz; a counter counts rising edges of IO10. The count starts at 0.
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

/// Latches the inputs and the counter in all modules of a group at once. It has the code of Save as Home.
struct SynchInput : CommandWithoutData<CommandCode::SaveAsHome> {};

/// A command that only a PIC-I/O knows.
template <typename T>
concept OwnCommand =
    AnyOf<T, SetDirection, SetPwm, SynchOutput, SetOutput, SetSynchOutput, SetTimerMode, SynchInput>;

}  // namespace nmc::io
