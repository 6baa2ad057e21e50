// SPDX-License-Identifier: MIT
#include "model/module/homewatch.h"

#include <utility>

namespace nmc {

template <typename SetHoming>
void HomeWatch::onSetHoming(const SetHoming& homing, TimePoint time) {
    const HomeWatch before = std::exchange(*this, HomeWatch{});
    if (!homing.watches())
        return;
    m_state = State::Armed;
    m_since = time;
    m_limit1 = homing.onLimit1Change;
    m_limit2 = homing.onLimit2Change;
    m_manner = homing.motorOff       ? std::optional(StopManner::Off)
               : homing.stopAbruptly ? std::optional(StopManner::Abruptly)
               : homing.stopSmoothly ? std::optional(StopManner::Smoothly)
                                     : std::nullopt;
    m_switchesOff = homing.motorOff;
    const bool tripped = before.m_state == State::Tripped && before.stops();
    m_leftOut1 = !m_limit1 && ((tripped && before.m_limit1) || before.m_leftOut1);
    m_leftOut2 = !m_limit2 && ((tripped && before.m_limit2) || before.m_leftOut2);
}

void HomeWatch::apply(const bus::CommandExecuted& executed) {
    if (const auto* homing = getIf<servo::SetHoming>(executed.command)) {
        onSetHoming(*homing, executed.time);
        m_positionError = homing->onPositionError;
        m_currentLimit = homing->onCurrentLimit;
        // A position error switches the servo off by itself.
        m_switchesOff = m_switchesOff || homing->onPositionError;
    } else if (const auto* step = getIf<stepper::SetHoming>(executed.command)) {
        onSetHoming(*step, executed.time);
    }
}

bool HomeWatch::apply(const bus::Sample& sample) {
    // The reply to the command itself may have been composed before the command took effect.
    if (m_state != State::Armed || sample.time <= m_since || (sample.report.status & 0x80U) != 0)
        return false;  // the same bit on both chips
    m_state = State::Tripped;
    return true;
}

}  // namespace nmc
