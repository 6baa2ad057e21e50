// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"

namespace nmc {

/// What a module was last told by Set Homing Mode, and what has come of it (DS-V 5.2, DS-S 5.1): the chip
/// shows only whether it still watches. A belief, as all of ModuleState.
class HomeWatch {
public:
    enum class State : std::uint8_t {
        Idle,     ///< not told, or cancelled
        Armed,    ///< watches
        Tripped,  ///< a condition came: the position was captured, and the motor stopped if that was wanted
    };

    void apply(const bus::CommandExecuted& executed);
    /// True when this sample tells that it has just tripped.
    bool apply(const bus::Sample& sample);

    [[nodiscard]] State state() const { return m_state; }
    /// Of Armed and Tripped.
    [[nodiscard]] bool onLimit1() const { return m_limit1; }
    [[nodiscard]] bool onLimit2() const { return m_limit2; }
    /// PIC-SERVO.
    [[nodiscard]] bool onPositionError() const { return m_positionError; }
    [[nodiscard]] bool onCurrentLimit() const { return m_currentLimit; }
    /// The chip itself stops the motor, or switches it off, when a condition comes.
    [[nodiscard]] bool stops() const { return m_stops; }
    /// A servo that is found off may have been switched off by it.
    [[nodiscard]] bool switchesOff() const { return m_switchesOff; }

private:
    template <typename SetHoming>
    void onSetHoming(const SetHoming& homing, TimePoint time, bool watches);

    State m_state = State::Idle;
    TimePoint m_since;
    bool m_limit1 = false;
    bool m_limit2 = false;
    bool m_positionError = false;
    bool m_currentLimit = false;
    bool m_stops = false;
    bool m_switchesOff = false;
};

}  // namespace nmc
