// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "module/registers.h"

namespace nmc::bus {

/// The outputs of a PIC-I/O that a stop takes low; all others stay as they are. Bit 0 is IO1, or PWM1.
struct StopOutputs {
    std::uint16_t pins = 0;
    std::uint8_t pwm = 0;
    bool operator==(const StopOutputs&) const = default;
};

/// What is believed about the outputs of a PIC-I/O. As with a motor, the worse case counts: an output that
/// may be high is sent low until this has been answered. Pure.
class IoOutputs {
public:
    void onReset();
    /// The module was found as another host left it: any output may be high.
    void forget();
    void onSent(const io::SetOutput& set);
    void onSent(const io::SetPwm& set);
    void onSent(const io::SynchOutput& synch);
    void onSent(const io::SetSynchOutput& /*set*/) { m_answered.stored.reset(); }
    void onSent(const auto& /*other*/) {}
    void onExecuted(const IoCommand& command);
    /// The last command was certainly not carried out. `before`: as it was sent.
    void onNotExecuted(const IoOutputs& before);
    /// The levels of all pins; outputs are read back.
    void onPins(std::uint16_t pins) { m_pins = pins; }

    /// The outputs stored for Synch Output; empty: none were stored in this connection, or it is unknown
    /// which.
    [[nodiscard]] const std::optional<io::SetSynchOutput>& stored() const { return m_answered.stored; }
    /// The levels as answered; empty: unknown.
    [[nodiscard]] std::optional<std::uint16_t> levels() const {
        return m_levelsOpen ? std::nullopt : m_answered.outputs;
    }

    void setStopOutputs(const StopOutputs& off) { m_off = off; }
    [[nodiscard]] const StopOutputs& stopOutputs() const { return m_off; }
    /// The next command needed for a stop; empty if no output that a stop takes low may be high, or while the
    /// levels of the others are unknown.
    [[nodiscard]] std::optional<IoCommand> stop() const;

private:
    StopOutputs m_off;
    std::uint16_t m_mayBeHigh = 0;
    std::array<bool, 2> m_pwmMayRun{};
    /// Registers as answered. A stop must switch nothing on, so what an unanswered command may have switched
    /// off, or changed to another PWM value, is 0.
    IoRegisters m_answered;
    bool m_levelsOpen = false;            ///< an unanswered command may have changed them
    std::optional<std::uint16_t> m_pins;  ///< as last read, likewise
};

}  // namespace nmc::bus
