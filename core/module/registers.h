// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/commands.h"
#include "protocol/moduletype.h"

/// The state that a module keeps from the commands that it carries out. The chips report almost none of it,
/// so this is the only copy, with a single definition of what each command changes. The caller decides which
/// commands count as carried out: those answered, or all that were sent. Empty means unknown. Value types,
/// one class per chip; a new object represents a module after a reset.
namespace nmc {

/// The part of I/O Control that affects paths.
struct PathControl {
    bool fastPath = false;          ///< 60 and 120 Hz instead of 30 and 60
    bool stepAndDirection = false;  ///< SC: the command position is not under the host's sole control
    bool operator==(const PathControl&) const = default;
};

/// The most that SR can be (DS-V 5.2, Set Gain).
inline constexpr int kLongestServoRate = 255;

/// Registers of a PIC-SERVO (DS-V 5.2).
struct ServoRegisters {
    void apply(const ServoCommand& command, const ModuleIdentity& module);
    /// Call when the chip has stopped the motor in this manner, by command or by itself: a loaded trajectory
    /// no longer waits, and its velocity may be 0.
    void stopped(servo::StopManner manner, const ModuleIdentity& module);
    /// The trajectory that a start would run: the last load, together with the values kept from earlier ones.
    [[nodiscard]] servo::LoadTrajectory trajectory() const;
    /// SC: limit protection is enabled, and the limit in this direction is closed; forward is limit 1.
    [[nodiscard]] bool limitEnds(servo::StatusByte status, bool reverse) const {
        return scIo && scIo->limitStop != servo::LimitStop::None &&
               (reverse ? status.limit2() : status.limit1());
    }
    /// True if a smooth stop can decelerate.
    [[nodiscard]] bool canDecelerate() const {
        return runningAcceleration && runningAcceleration->value() != 0;
    }

    servo::LoadTrajectory load;  ///< the last one; its control bits hold until the next load
    bool loadWaiting = false;    ///< `load` waits for a start
    std::optional<Counts> goal;  ///< loaded last, except by relative moves
    /// Loaded last, for the next start; 0 after power-up (DS-V 4.5).
    std::optional<CountsPerTick> velocity = CountsPerTick(0);
    std::optional<CountsPerTickSquared> acceleration;         ///< likewise
    std::optional<CountsPerTick> runningVelocity;             ///< of the last start
    std::optional<CountsPerTickSquared> runningAcceleration;  ///< likewise: that of a smooth stop
    std::optional<bool> amplifierEnabled = false;             ///< AMP_EN; low after power-up
    std::optional<servo::SetGain> gains;
    /// SR, which is set with the gains; 1 after power-up (DS-V 4.5). Empty: the length of a tick is unknown.
    std::optional<int> servoRate = 1;
    std::optional<servo::IoControl> io;      ///< versions 1 to 5
    std::optional<servo::ScIoControl> scIo;  ///< SC, instead of `io`
    std::optional<PathControl> pathControl = PathControl{};

private:
    void started();
};

/// Registers of a PIC-STEP (DS-S 5.1).
struct StepperRegisters {
    void apply(const StepperCommand& command);
    /// Call when the chip has stopped the motor in this manner, by command or by itself: a loaded trajectory
    /// no longer waits, and its speed may be 0.
    void stopped(stepper::StopManner manner);

    std::optional<stepper::SetParameters> parameters;
    std::optional<std::uint8_t> outputs = std::uint8_t{0x10};  ///< OUT5 high, the rest low (DS-S 2.3)
    std::optional<std::uint8_t> loadedSpeed;                   ///< for the next start; 0 after a smooth stop
    std::optional<std::uint8_t> loadedTime;                    ///< acceleration time, for the next start
    std::optional<std::uint8_t> accelerationTime;              ///< of the last start: that of a smooth stop
    std::optional<stepper::LoadTrajectory> waiting;            ///< waits for a start
};

/// Registers of a PIC-I/O (docs/family.md). In masks, bit 0 is IO1.
struct IoRegisters {
    void apply(const IoCommand& command);
    /// Call for a module found as another host left it.
    void attached();
    /// It is unknown whether a command with this code was carried out.
    void doubt(CommandCode command);
    /// The levels to send for all pins so that outputs stay as they are: those last set if known, otherwise
    /// those read. Empty: unknown.
    [[nodiscard]] std::optional<std::uint16_t> levels(const StatusReport& latest) const {
        return outputs ? outputs : latest.pins;
    }

    std::optional<std::uint16_t> inputs = io::kAllPins;  ///< a set bit is an input
    std::optional<std::uint16_t> outputs;                ///< the levels that outputs were set to
    std::optional<std::array<std::uint8_t, 2>> pwm = std::array<std::uint8_t, 2>{};
    std::optional<io::SetTimerMode> timer = io::SetTimerMode{};
    std::optional<io::SetSynchOutput> stored;  ///< waits for Synch Output
};

}  // namespace nmc
