// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/exchange.h"
#include "bus/iooutputs.h"
#include "bus/types.h"
#include "module/stepperrun.h"

namespace nmc::bus {

/// PIC-SERVO: true if a sticky bit is set, apart from pos_error of a servo that is off (DS-V 5.3).
[[nodiscard]] bool anySticky(servo::StatusByte status, servo::AuxByte aux);

/// What the host believes about one module: the last status, and what was sent since. The chips report
/// neither trajectory nor mode, so this is the only copy, and it errs on the side of caution: for a command
/// that was sent but not answered, it assumes the worse outcome. Pure; used by the command gate, the hold and
/// the stop plan.
class Belief {
public:
    /// Statuses may be a millisecond apart, in which a slow motor moves by less than a count.
    static constexpr Duration kRollTime = std::chrono::milliseconds(10);

    explicit Belief(ModuleInfo info) : m_info(info) {}

    /// `command` was passed to the line and will be latched at `latched`. A refused command was certainly not
    /// carried out; the caller then restores the belief from before.
    void onSent(const ModuleCommand& command, TimePoint latched);
    /// The last command was answered as carried out. `answer`: what the module said, if that is known, with
    /// nothing withheld (trust.h).
    void onExecuted(const ModuleCommand& command, const StatusReport* answer = nullptr);
    void onStatus(const StatusReport& report, TimePoint latched);
    /// Define Status was sent but not answered: replies have the old or the new length.
    void forgetItems() { m_items.reset(); }
    /// The module was found as another host left it: its settings are unknown. It may be running in velocity
    /// mode at any speed until a stop is answered or its servo is seen off.
    void attach() {
        m_may.run = m_may.pwmUnknown = m_parametersSet = true;
        m_info.group.reset();
        m_servo.pathControl.reset();
        m_servo.velocity.reset();
        m_servo.servoRate.reset();
        m_outputs.forget();
    }
    /// The same module, found again at its address by another search of the same connection: it has not
    /// restarted, or it would not answer there, and it was sent only queries.
    void foundAgain(ModuleIndex index) { m_info.index = index; }
    /// What was loaded must not be started any more.
    void forgetLoad() {
        m_servo.loadWaiting = false;
        m_stepper.waiting.reset();
    }
    /// The last command was certainly not carried out, as its verification showed.
    void onNotExecuted(const Belief& before);
    /// The module has another address, and is otherwise unchanged.
    void setAddress(BusAddress address) { m_info.address = address; }
    /// The module restarted by itself, is off, and has lost its address: nothing is sent to it.
    void setRestarted();
    [[nodiscard]] bool restarted() const { return m_restarted; }

    [[nodiscard]] const ModuleInfo& info() const { return m_info; }
    /// The defined items of a reply; empty while they are in doubt.
    [[nodiscard]] std::optional<StatusItems> items() const { return m_items; }

    /// True if a status was latched after the last command that can move or stop the motor.
    [[nodiscard]] bool fresh() const;
    [[nodiscard]] std::optional<TimePoint> statusTime() const { return m_statusTime; }
    /// Number of statuses latched since `time`, at most 2.
    [[nodiscard]] unsigned looksSince(TimePoint time) const;
    /// The items to request next, so that the reply differs in length from the last one (link.md 2.2).
    [[nodiscard]] StatusItems otherItems() const;
    [[nodiscard]] std::optional<std::int32_t> position() const { return m_position; }
    /// According to the last status.
    [[nodiscard]] bool anySticky() const {
        return bus::anySticky(m_last.servoStatus(), servo::AuxByte{m_aux});
    }
    [[nodiscard]] std::optional<std::int32_t> home() const { return m_home; }
    /// CMC and SC: the position that the servo should hold or follow, from the last status that contained it.
    [[nodiscard]] std::optional<std::int32_t> commandPosition() const { return m_commandPosition; }
    /// CMC and SC: it may be running path points.
    [[nodiscard]] bool onPath() const { return m_may.followPath; }

    /// Servo (PIC-STEP: amplifier) is on, according to the last status that contained it.
    [[nodiscard]] bool on() const { return m_on; }
    /// It is on, or a command that may have switched it on was sent since.
    [[nodiscard]] bool mayBeOn() const { return m_on || m_may.enable; }
    /// PIC-SERVO: AMP_EN was taken low, and not high since; raising it would make a servo that is on jump.
    [[nodiscard]] bool amplifierOff() const { return m_amplifierOff; }
    /// PIC-SERVO with the servo off whose PWM output may differ from 0.
    [[nodiscard]] bool pwmMayRun() const { return m_may.drivePwm; }
    /// The PWM output may differ from 0 because earlier commands are unknown; a stop must allow for this.
    [[nodiscard]] bool pwmUnknown() const { return m_may.pwmUnknown; }
    /// The command velocity may differ from 0 (DS-V 4.4), or a stepper is moving.
    [[nodiscard]] bool mayMove() const {
        return !m_restarted && moves(m_may.run || m_may.drivePwm || m_may.followPath);
    }
    /// Measured velocity in counts per tick, if the latest status contained it.
    [[nodiscard]] std::optional<std::int16_t> velocity() const { return m_last.velocity; }
    /// The position has changed by more than a count within kRollTime, or since the last status. This shows a
    /// motor that turns by less than the resolution of the velocity item, a count per tick.
    [[nodiscard]] bool rolls() const { return m_rolls; }
    /// The last status shows motion, whatever was commanded. True if there is no status.
    [[nodiscard]] bool seenMoving() const {
        return moves(m_may.drivePwm || m_last.velocity.value_or(0) != 0 || m_rolls);
    }
    /// The last status itself shows motion, or does not contain the velocity that would, whatever was sent.
    [[nodiscard]] bool showsMotion() const;
    /// True if a Stop Motor is likely to stop something; determines the order of a stop.
    [[nodiscard]] bool moving() const {
        return mayMove() || (!m_restarted && m_last.velocity.value_or(0) != 0);
    }

    /// A status newer than the last command that can move or stop the motor shows that it stands.
    [[nodiscard]] bool standsStill() const { return fresh() && !moving(); }

    /// A Load Trajectory was answered and not used by a start or a stop since.
    [[nodiscard]] std::optional<servo::LoadTrajectory> servoLoad() const {
        return m_servo.loadWaiting ? std::optional(m_servo.load) : std::nullopt;
    }
    [[nodiscard]] const std::optional<stepper::LoadTrajectory>& stepperLoad() const {
        return m_stepper.waiting;
    }
    /// PIC-SERVO: it was sent a run in velocity mode, which has not been seen to end.
    [[nodiscard]] bool velocityGoal() const { return m_may.run; }
    /// PIC-STEP: its mode, as far as status and commands show it.
    [[nodiscard]] StepperMode stepperMode() const;
    /// The direction of velocityGoal(), or of a moving PIC-STEP.
    [[nodiscard]] bool runsReverse() const {
        return m_info.identity.type == ModuleType::Stepper ? m_may.stepperRun.reverse.value_or(false)
                                                           : m_may.runReverse;
    }
    /// As answered by the module.
    [[nodiscard]] const ServoRegisters& servoRegisters() const { return m_servo; }
    [[nodiscard]] const StepperRegisters& stepperRegisters() const { return m_stepper; }
    /// PIC-STEP: Set Parameters was answered, or may have been before this connection (DS-S 5.1).
    [[nodiscard]] bool parametersSet() const { return m_parametersSet; }
    /// PIC-I/O: its outputs, and which of them a stop takes low.
    [[nodiscard]] const IoOutputs& outputs() const { return m_outputs; }
    void setStopOutputs(const StopOutputs& off) { m_outputs.setStopOutputs(off); }
    void forgetOutputs(const StopOutputs& off) {
        m_outputs.setStopOutputs(off);
        m_outputs.forget();
    }

private:
    struct Sent;
    struct Executed;
    void mayStart(const servo::LoadTrajectory& load);
    void mayStart(const stepper::LoadTrajectory& load);
    void started(const servo::LoadTrajectory& load);
    void rename();
    void onPosition(std::int32_t position, TimePoint latched);
    /// `servo`: what else than a clear move_done shows that a PIC-SERVO moves.
    [[nodiscard]] bool moves(bool servo) const;

    /// What the motor may do because of the commands sent, at worst.
    struct May {
        bool enable = false;      ///< since a command that may switch it on, until a status shows it
        bool drivePwm = false;    ///< since a start that was sent, until a stop is answered
        bool pwmUnknown = false;  ///< since attach(), until a stop or a start is answered
        bool run = false;         ///< velocity mode with a goal other than 0
        bool runReverse = false;  ///< of the last start sent; meaningful only with `run`
        bool followPath = false;
        StepperRun stepperRun;                            ///< the last start sent; meaningful only in motion
        std::optional<servo::LoadTrajectory> starting{};  ///< what the last start runs, if carried out
    };

    ModuleInfo m_info;
    std::optional<StatusItems> m_items = StatusItems{};
    std::optional<TimePoint> m_statusTime;
    std::optional<TimePoint> m_lastMotion;
    StatusReport m_last;
    std::optional<std::int32_t> m_position;
    /// A position that later ones are compared with, unless the counter has been set since.
    struct Place {
        std::int32_t position = 0;
        TimePoint since;
    };
    std::optional<Place> m_place;
    bool m_rolls = false;
    std::optional<std::int32_t> m_home;
    std::uint8_t m_aux = 0;
    std::optional<TimePoint> m_before;  ///< the status before the last one
    bool m_on = false;                  ///< according to a status; no command alone sets it
    bool m_amplifierOff = false;        ///< set when answered, cleared when sent
    bool m_homingStops = false;         ///< the chip itself stops when home is found
    bool m_parametersSet = false;       ///< since an answer or attach(), until a restart
    bool m_restarted = false;           ///< never cleared: welcome() creates another Belief
    May m_may;
    // As answered; whatever an unanswered command may change is not waiting, or is unknown.
    ServoRegisters m_servo;
    StepperRegisters m_stepper;
    IoOutputs m_outputs;
    std::optional<std::int32_t> m_commandPosition;
};

}  // namespace nmc::bus
