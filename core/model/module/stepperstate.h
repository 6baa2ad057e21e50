// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "model/module/activity.h"
#include "module/registers.h"
#include "module/stepperrun.h"

namespace nmc {

/// What a PIC-STEP was sent in this connection, and what follows from that and its status; a part of
/// ModuleState. The chip composes the reply to a command before it carries the command out, so only a status
/// latched later shows its effect.
///
/// The registers are public members, as confirmed in this connection. Without parameters, motion is not
/// allowed.
class StepperState : public StepperRegisters {
public:
    /// The module was found as another host left it.
    void attached();
    /// The module lost all its settings.
    void restarted();
    /// `latest` has every item ever reported; `time` is when its status was latched. `homeFound`: this status
    /// shows that what homing watched for has just occurred.
    void apply(const StatusReport& latest, TimePoint time, bool homeFound = false);
    void apply(const StepperCommand& executed, TimePoint time);

    [[nodiscard]] bool amplifierOn() const { return m_on; }
    /// The module switched its amplifier off without a command, according to two replies in a row, and has
    /// not been on since.
    [[nodiscard]] bool offByItself() const { return m_offByItself; }
    /// According to one reply; the next one decides.
    [[nodiscard]] bool maybeOff() const { return m_offOnce; }
    [[nodiscard]] bool moving() const { return m_startedAt || m_status.moving(); }
    [[nodiscard]] StepperMode mode() const;
    /// Direction of the present motion; empty: it stands still, or another host started it.
    [[nodiscard]] std::optional<bool> runsReverse() const { return moving() ? m_run.reverse : std::nullopt; }

    /// Goal of the last motion, if it has one.
    [[nodiscard]] std::optional<std::int32_t> goal() const { return m_run.goal; }
    /// The direction of the last motion; empty: another host started it.
    [[nodiscard]] std::optional<bool> lastReverse() const { return m_run.reverse; }
    /// What ended the last motion, or switched the amplifier off, unless commanded; reset by the next command
    /// to move, stop or switch.
    [[nodiscard]] std::optional<Activity> ended() const { return m_ended; }
    [[nodiscard]] bool powered() const { return m_status.powerOn(); }
    [[nodiscard]] bool estopActs() const;
    /// The limit switch in that direction is active and stops the motor.
    [[nodiscard]] bool limitActs(bool reverse) const;
    [[nodiscard]] bool tooHot() const;
    [[nodiscard]] std::optional<std::int32_t> position() const { return m_position; }
    [[nodiscard]] stepper::InputsByte inputs() const { return m_inputs; }

    /// For a module that answers.
    [[nodiscard]] Activity activity() const;

private:
    struct Executed;
    void started(const stepper::LoadTrajectory& load, TimePoint time);
    void stopped(const stepper::StopMotor& stop, TimePoint time);
    void watchAmplifier(bool wasOn);
    void watchMotion(bool wasMoving, bool homeFound);
    [[nodiscard]] std::optional<Activity> whatActs() const;

    stepper::StatusByte m_status;
    stepper::InputsByte m_inputs;
    std::optional<std::uint8_t> m_analog;
    std::optional<std::int32_t> m_position;
    std::optional<std::uint16_t> m_timer;

    StepperRun m_run;
    std::optional<TimePoint> m_startedAt;   ///< a motion was started, and no later status has arrived
    std::optional<TimePoint> m_switchedAt;  ///< the amplifier was switched, and no later status has arrived
    bool m_on = false;
    bool m_offCommanded = false;
    bool m_offByItself = false;
    bool m_offOnce = false;  ///< one reply shows it off by itself, and the next has not arrived yet
    std::optional<Activity> m_offCause;  ///< cause according to that reply
    bool m_homingSwitchesOff = false;
    bool m_stopping = false;  ///< smoothly, by command
    bool m_slowing = false;   ///< between the last two statuses
    bool m_ourStop = false;
    std::optional<Activity> m_ended;  ///< what ended the last motion, or switched it off
};

}  // namespace nmc
