// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/commands.h"
#include "protocol/status.h"

namespace nmc {

/// What a PIC-I/O was told in this connection, as last confirmed: a part of ModuleState. The chip reports the
/// levels of its pins, outputs included, but neither their directions nor what its outputs were told. Of
/// masks, bit 0 is IO1. Pure.
class PinState {
public:
    /// Found as another host left it.
    void attached();
    /// It lost everything it was told: all pins are inputs.
    void restarted() { *this = {}; }
    void apply(const IoCommand& executed);

    /// Set: an input. Empty: unknown.
    [[nodiscard]] std::optional<std::uint16_t> inputs() const { return m_inputs; }
    /// What outputs were told; empty: unknown.
    [[nodiscard]] std::optional<std::uint16_t> told() const { return m_told; }
    /// PWM1 and PWM2; empty: unknown.
    [[nodiscard]] std::optional<std::array<std::uint8_t, 2>> pwm() const { return m_pwm; }
    [[nodiscard]] const std::optional<io::SetTimerMode>& timer() const { return m_timer; }
    /// What waits for Synch Output; empty: nothing that is known here.
    [[nodiscard]] const std::optional<io::SetSynchOutput>& stored() const { return m_stored; }

    /// What all pins are to be told so that outputs stay as they are: as they were told, otherwise as they
    /// read. Empty: nobody knows.
    [[nodiscard]] std::optional<std::uint16_t> levels(const StatusReport& latest) const {
        return m_told ? m_told : latest.pins;
    }

private:
    struct Executed;

    std::optional<std::uint16_t> m_inputs = io::kAllPins;
    std::optional<std::uint16_t> m_told;
    std::optional<std::array<std::uint8_t, 2>> m_pwm = std::array<std::uint8_t, 2>{};
    std::optional<io::SetTimerMode> m_timer = io::SetTimerMode{};
    std::optional<io::SetSynchOutput> m_stored;
};

}  // namespace nmc
