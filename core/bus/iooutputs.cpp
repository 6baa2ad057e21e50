// SPDX-License-Identifier: MIT
#include "bus/iooutputs.h"

namespace nmc::bus {

void IoOutputs::onReset() {
    const StopOutputs off = m_off;
    *this = {};
    m_off = off;
}

void IoOutputs::forget() {
    m_mayBeHigh = io::kAllPins;
    m_pwmMayRun = {true, true};
    m_answered.attached();
}

void IoOutputs::onSent(const io::SetOutput& set) {
    m_mayBeHigh |= set.outputs;
    m_levelsOpen = m_levelsOpen || m_answered.outputs != set.outputs;
    if (m_answered.outputs)
        *m_answered.outputs &= set.outputs;
    if (m_pins)
        *m_pins &= set.outputs;  // until they are read again
}

void IoOutputs::onSent(const io::SetPwm& set) {
    const std::array<std::uint8_t, 2> values{set.pwm1, set.pwm2};
    for (std::size_t i = 0; i < values.size(); ++i) {
        m_pwmMayRun[i] = m_pwmMayRun[i] || values[i] != 0;
        if (m_answered.pwm && (*m_answered.pwm)[i] != values[i])
            (*m_answered.pwm)[i] = 0;
    }
}

void IoOutputs::onSent(const io::SynchOutput& /*synch*/) {
    const auto stored = m_answered.stored;
    if (!stored)
        return forget();  // any level may be put out
    onSent(io::SetOutput{stored->outputs});
    onSent(io::SetPwm{stored->pwm1, stored->pwm2});
}

void IoOutputs::onExecuted(const IoCommand& command) {
    m_answered.apply(command);
    const bool synch = std::holds_alternative<io::SynchOutput>(command);
    const bool setsPins = synch || std::holds_alternative<io::SetOutput>(command);
    m_levelsOpen = m_levelsOpen && !setsPins;
    // What Synch Output may have set from another host's stored outputs was noted when it was sent.
    if (setsPins && m_answered.outputs)
        m_mayBeHigh = *m_answered.outputs;
    if ((synch || std::holds_alternative<io::SetPwm>(command)) && m_answered.pwm)
        m_pwmMayRun = {(*m_answered.pwm)[0] != 0, (*m_answered.pwm)[1] != 0};
}

void IoOutputs::onNotExecuted(const IoOutputs& before) {
    m_mayBeHigh = before.m_mayBeHigh;
    m_pwmMayRun = before.m_pwmMayRun;
    m_answered = before.m_answered;
    m_levelsOpen = before.m_levelsOpen;
}

std::optional<IoCommand> IoOutputs::stop() const {
    const std::optional<std::uint16_t> levels = m_answered.outputs ? m_answered.outputs : m_pins;
    if ((m_mayBeHigh & m_off.pins) != 0 && levels)
        return io::SetOutput{static_cast<std::uint16_t>(*levels & ~unsigned{m_off.pins})};
    const std::array<bool, 2> off{(m_off.pwm & 1U) != 0, (m_off.pwm & 2U) != 0};
    if ((off[0] && m_pwmMayRun[0]) || (off[1] && m_pwmMayRun[1])) {
        // A PWM output with an unknown value is switched off with the other: the chip takes both at once and
        // reports neither.
        const std::array<std::uint8_t, 2> values = m_answered.pwm.value_or(std::array<std::uint8_t, 2>{});
        return io::SetPwm{off[0] ? std::uint8_t{0} : values[0], off[1] ? std::uint8_t{0} : values[1]};
    }
    return std::nullopt;
}

}  // namespace nmc::bus
