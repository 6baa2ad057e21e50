// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "module/registers.h"

namespace nmc::bus {

/// Which outputs of a PIC-I/O a stop takes low; all others stay as they are. Bit 0 is IO1, or PWM1.
struct StopOutputs {
    std::uint16_t pins = 0;
    std::uint8_t pwm = 0;
    bool operator==(const StopOutputs&) const = default;
};

/// What is believed of the outputs of one PIC-I/O. Like a motor, an output that may be high counts as high:
/// one is told to go low until that was answered. Pure.
class IoOutputs {
public:
    void onReset();
    /// Found as another host left it: any of them may be high.
    void forget();
    void onSent(const io::SetOutput& set) { m_mayBeHigh |= set.outputs; }
    void onSent(const io::SetPwm& set);
    void onSent(const io::SynchOutput& synch);
    void onSent(const auto& /*other*/) {}
    void onExecuted(const IoCommand& command);
    /// The levels of all pins; outputs read back.
    void onPins(std::uint16_t pins) { m_pins = pins; }

    /// What waits for Synch Output; empty: nothing that was stored in this connection.
    [[nodiscard]] const std::optional<io::SetSynchOutput>& stored() const { return m_answered.stored; }
    /// As answered; empty: not known.
    [[nodiscard]] std::optional<std::uint16_t> levels() const { return m_answered.outputs; }

    void setStopOutputs(const StopOutputs& off) { m_off = off; }
    [[nodiscard]] const StopOutputs& stopOutputs() const { return m_off; }
    /// What is still to be told, one command after the other; nothing when no output that a stop takes low
    /// may be high, or when it is not known yet how the others are.
    [[nodiscard]] std::optional<IoCommand> stop() const;

private:
    StopOutputs m_off;
    std::uint16_t m_mayBeHigh = 0;
    std::array<bool, 2> m_pwmMayRun{};
    IoRegisters m_answered;  ///< as answered
    std::optional<std::uint16_t> m_pins;
};

}  // namespace nmc::bus
