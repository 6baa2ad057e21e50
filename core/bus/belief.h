// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/exchange.h"
#include "bus/iooutputs.h"
#include "bus/steppergate.h"
#include "bus/types.h"

namespace nmc::bus {

/// PIC-SERVO: a sticky bit is set, other than pos_error of a servo that is off (DS-V 5.3).
[[nodiscard]] bool anySticky(servo::StatusByte status, servo::AuxByte aux);

/// What the host believes about one module: the last status and what was sent since. The chips tell neither
/// trajectory nor mode, so this is the only copy, and it errs to the careful side: a command that was sent
/// and not answered counts as carried out where that is the worse case, and as not where that is. Pure; the
/// command gate, the hold and the stop plan read it.
class Belief {
public:
    explicit Belief(ModuleInfo info) : m_info(info) {}

    /// `command` was handed to the wire and will be latched at `latched`. A refused command was certainly not
    /// carried out: the caller puts back the belief from before.
    void onSent(const ModuleCommand& command, TimePoint latched);
    /// The command that was sent last was answered as carried out.
    void onExecuted(const ModuleCommand& command);
    void onStatus(const StatusReport& report, TimePoint latched);
    /// Define Status was sent and not answered: replies have the old or the new length.
    void forgetItems() { m_items.reset(); }
    /// Found as another host left it: what it was told is not known. It may run in velocity mode at any
    /// speed, until a stop is answered or its servo is seen off.
    void attach() {
        m_velocityGoal = m_pwmUnknown = m_parametersSet = true;
        m_info.group.reset();
        m_servo.pathControl.reset();
        m_outputs.forget();
    }
    /// The same module, found at its address by another look of the same connection: it has not restarted, or
    /// it would not answer there, and it was sent nothing but questions.
    void foundAgain(ModuleIndex index) { m_info.index = index; }
    /// A load was asked for and refused: an older one that waits must not start in its place.
    void forgetLoad() {
        m_servo.loadWaiting = false;
        m_stepper.waiting.reset();
    }
    /// The command that was sent last was certainly not carried out, as a look has shown.
    void onNotExecuted(const Belief& before);
    /// It has another address, and is what it was.
    void setAddress(BusAddress address) { m_info.address = address; }
    /// It restarted by itself, is off, and has no address any more: nothing is sent to it.
    void setRestarted();
    [[nodiscard]] bool restarted() const { return m_restarted; }

    [[nodiscard]] const ModuleInfo& info() const { return m_info; }
    /// The defined items of a reply; nothing while they are in doubt.
    [[nodiscard]] std::optional<StatusItems> items() const { return m_items; }

    /// A status was latched after the last command that can move or stop the motor.
    [[nodiscard]] bool fresh() const;
    [[nodiscard]] std::optional<TimePoint> statusTime() const { return m_statusTime; }
    /// How many statuses were latched since then.
    [[nodiscard]] unsigned looksSince(TimePoint time) const;
    /// Items to ask for next: a reply of another length than the last one (link.md 2.2).
    [[nodiscard]] StatusItems otherItems() const;
    [[nodiscard]] std::optional<std::int32_t> position() const { return m_position; }
    /// As of the last status.
    [[nodiscard]] bool anySticky() const {
        return bus::anySticky(servo::StatusByte{m_status}, servo::AuxByte{m_aux});
    }
    [[nodiscard]] std::optional<std::int32_t> home() const { return m_home; }
    /// CMC and SC: what the servo is told to hold or follow, of the last status that told.
    [[nodiscard]] std::optional<std::int32_t> commandPosition() const { return m_commandPosition; }
    /// CMC and SC: nothing when nobody here knows what I/O Control was told.
    [[nodiscard]] const std::optional<PathControl>& pathControl() const { return m_servo.pathControl; }
    /// CMC and SC: it may be running through path points.
    [[nodiscard]] bool onPath() const { return m_onPath; }

    /// Servo (PIC-STEP: amplifier) as of the last status that told.
    [[nodiscard]] bool on() const { return m_on; }
    /// Same, or a command that could have switched it on was sent since.
    [[nodiscard]] bool mayBeOn() const { return m_on || m_mayEnable; }
    /// PIC-SERVO: AMP_EN was taken low, and not high since: raising it would let a servo that is on leap.
    [[nodiscard]] bool amplifierOff() const { return m_amplifierOff; }
    /// PIC-SERVO with the servo off whose PWM output may be other than 0.
    [[nodiscard]] bool pwmMayRun() const { return m_pwmMayRun; }
    /// The same where nobody here knows what it was told before: a stop must reckon with it.
    [[nodiscard]] bool pwmUnknown() const { return m_pwmUnknown; }
    /// The command velocity may be other than 0 (DS-V 4.4), or a stepper is moving.
    [[nodiscard]] bool mayMove() const;
    /// Measured velocity, counts per tick, when the newest status had it.
    [[nodiscard]] std::optional<std::int16_t> velocity() const { return m_velocity; }
    /// The last two positions that were told lie apart: with the servo off, a motor that coasts by less than
    /// the velocity item tells, a count per tick.
    [[nodiscard]] bool rolls() const { return m_rolls; }
    [[nodiscard]] bool powered() const;
    /// The last status shows a motion, whatever it was told. True when there is none.
    [[nodiscard]] bool seenMoving() const;
    /// Whether a Stop Motor must be expected to find something to stop, for the order of a stop.
    [[nodiscard]] bool moving() const { return mayMove() || m_velocity.value_or(0) != 0; }

    /// A Load Trajectory that was answered and not used up by a start or a stop.
    [[nodiscard]] bool loaded() const { return servoLoad() || stepperLoad(); }
    [[nodiscard]] std::optional<servo::LoadTrajectory> servoLoad() const {
        return m_servo.loadWaiting ? std::optional(m_servo.load) : std::nullopt;
    }
    [[nodiscard]] const std::optional<stepper::LoadTrajectory>& stepperLoad() const {
        return m_stepper.waiting;
    }
    /// PIC-SERVO: it was told to run in velocity mode, and has not been seen to end that.
    [[nodiscard]] bool velocityGoal() const { return m_velocityGoal; }
    /// PIC-STEP: what it does, as far as status and commands tell.
    [[nodiscard]] StepperMode stepperMode() const;
    /// The direction of velocityGoal(), or of a PIC-STEP that moves.
    [[nodiscard]] bool runsReverse() const {
        return m_info.identity.type == ModuleType::Stepper ? m_stepperReverse : m_velocityReverse;
    }
    /// As answered.
    [[nodiscard]] const ServoRegisters& servoRegisters() const { return m_servo; }
    [[nodiscard]] const StepperRegisters& stepperRegisters() const { return m_stepper; }
    /// PIC-STEP: Set Parameters was answered, or may have been before this connection (DS-S 5.1).
    [[nodiscard]] bool parametersSet() const { return m_parametersSet; }
    /// PIC-I/O: what it puts out, and which of that a stop takes low.
    [[nodiscard]] const IoOutputs& outputs() const { return m_outputs; }
    void setStopOutputs(const StopOutputs& off) { m_outputs.setStopOutputs(off); }
    void forgetOutputs(const StopOutputs& off) {
        m_outputs.setStopOutputs(off);
        m_outputs.forget();
    }
    /// As answered in this connection.
    [[nodiscard]] const std::optional<stepper::SetParameters>& parameters() const {
        return m_stepper.parameters;
    }

private:
    struct Sent;
    struct Executed;
    void mayStart(const servo::LoadTrajectory& load);
    void started(const servo::LoadTrajectory& load);
    void mayStart(const stepper::LoadTrajectory& load);
    void rename();

    ModuleInfo m_info;
    std::optional<StatusItems> m_items = StatusItems{};
    std::optional<TimePoint> m_statusTime;
    std::optional<TimePoint> m_lastMotion;
    std::uint8_t m_status = 0;
    std::optional<std::int16_t> m_velocity;
    std::optional<std::int32_t> m_position;
    std::optional<std::int32_t> m_place;  ///< position, unless it has been renamed since
    bool m_rolls = false;
    std::optional<std::int32_t> m_home;
    StatusItems m_lastItems;
    std::uint8_t m_aux = 0;
    std::optional<TimePoint> m_before;  ///< the status before the last one
    bool m_on = false;                  ///< by a status; no command alone switches it on here
    bool m_mayEnable = false;           ///< from such a command on, until a status tells
    bool m_amplifierOff = false;        ///< low counts when answered, high when sent
    bool m_pwmMayRun = false;           ///< from a start that was sent, to a stop that is answered
    bool m_pwmUnknown = false;          ///< from attach(), until a stop or a start is answered
    bool m_velocityGoal = false;        ///< velocity mode with a goal other than 0
    bool m_velocityReverse = false;     ///< of the last start that was sent; of no meaning without the goal
    bool m_limitStops = false;          ///< SC, told so: the chip ends what goes towards a closed limit
    bool m_homingStops = false;         ///< the chip itself stops when home is found
    bool m_parametersSet = false;       ///< from an answer or attach(), until a restart
    bool m_stepperReverse = false;      ///< of the last start that was sent; of no meaning at rest
    std::optional<StepperMode> m_stepperGoal;  ///< of what may run
    bool m_restarted = false;                  ///< once true, stays so: welcome() makes another Belief
    // As answered; what a command may change that has not been answered does not wait, or is not known.
    ServoRegisters m_servo;
    StepperRegisters m_stepper;
    IoOutputs m_outputs;
    std::optional<std::int32_t> m_commandPosition;
    bool m_onPath = false;
    std::optional<servo::LoadTrajectory> m_starting;  ///< what the last start, if carried out, runs
};

}  // namespace nmc::bus
