// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"
#include "module/stopmanner.h"

namespace nmc {

/// What Set Homing Mode last requested from a module, and the outcome (DS-V 5.2, DS-S 5.1): the chip reports
/// only whether it is still watching. A belief, like all of ModuleState.
class HomeWatch {
public:
    enum class State : std::uint8_t {
        Idle,     ///< not commanded, or cancelled
        Armed,    ///< watching
        Tripped,  ///< a condition occurred: the position was captured, and the motor stopped if so requested
    };

    void apply(const bus::CommandExecuted& executed);
    /// Returns true when this sample shows that a condition has just occurred.
    bool apply(const bus::Sample& sample);

    [[nodiscard]] State state() const { return m_state; }
    /// Valid while Armed or Tripped.
    [[nodiscard]] bool onLimit1() const { return m_limit1; }
    [[nodiscard]] bool onLimit2() const { return m_limit2; }
    /// PIC-SERVO only.
    [[nodiscard]] bool onPositionError() const { return m_positionError; }
    [[nodiscard]] bool onCurrentLimit() const { return m_currentLimit; }
    /// How the chip itself stops the motor when a condition occurs; empty: it does not.
    [[nodiscard]] std::optional<StopManner> manner() const { return m_manner; }
    [[nodiscard]] bool stops() const { return m_manner.has_value(); }
    /// True if a servo that is found off may have been switched off by homing.
    [[nodiscard]] bool switchesOff() const { return m_switchesOff; }
    /// True while Armed if a stop that watched this limit has tripped, and was armed again without it.
    [[nodiscard]] bool trippedBeforeAtLimit1() const { return m_leftOut1; }
    [[nodiscard]] bool trippedBeforeAtLimit2() const { return m_leftOut2; }

private:
    template <typename SetHoming>
    void onSetHoming(const SetHoming& homing, TimePoint time);

    State m_state = State::Idle;
    TimePoint m_since;
    bool m_limit1 = false;
    bool m_limit2 = false;
    bool m_positionError = false;
    bool m_currentLimit = false;
    std::optional<StopManner> m_manner;
    bool m_switchesOff = false;
    bool m_leftOut1 = false;  ///< see trippedBeforeAtLimit1()
    bool m_leftOut2 = false;
};

}  // namespace nmc
