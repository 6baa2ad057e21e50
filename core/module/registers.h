// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/commands.h"

/// What a module keeps of the commands that it carries out. The chips report next to none of it, so this is
/// the only copy, with one rule for what a command changes. Whoever feeds it decides what counts as carried
/// out: commands that were answered, or all that were sent. Empty means not known. Values, one class for each
/// chip; a new object is a module after a reset.
namespace nmc {

/// What I/O Control has to do with paths.
struct PathControl {
    bool fastPath = false;          ///< 60 and 120 Hz instead of 30 and 60
    bool stepAndDirection = false;  ///< of an SC: its command position is not the host's alone
    bool operator==(const PathControl&) const = default;
};

/// PIC-SERVO (DS-V 5.2).
struct ServoRegisters {
    void apply(const ServoCommand& command);
    /// The chip has stopped the motor, by command or by itself: its velocity is 0, and what was loaded does
    /// not wait any more.
    void stopped();
    /// What a start would run: the load that came last, and what it kept of those before.
    [[nodiscard]] servo::LoadTrajectory trajectory() const;
    /// A smooth stop can slow down.
    [[nodiscard]] bool accelerationLoaded() const { return acceleration && acceleration->value() != 0; }

    servo::LoadTrajectory load;  ///< the last one; its control bits hold until the next
    bool loadWaiting = false;    ///< for a start
    std::optional<Counts> goal;  ///< loaded last, but for relative moves
    std::optional<CountsPerTick> velocity;
    std::optional<CountsPerTickSquared> acceleration;
    bool amplifierEnabled = false;
    std::optional<servo::SetGain> gains;
    /// SR, which goes with the gains; 1 after power-up (DS-V 4.5). Empty: nobody knows how long a tick is.
    std::optional<int> servoRate = 1;
    std::optional<servo::IoControl> io;      ///< versions 1 to 5
    std::optional<servo::ScIoControl> scIo;  ///< of an SC, instead
    std::optional<PathControl> pathControl = PathControl{};
};

/// PIC-STEP (DS-S 5.1).
struct StepperRegisters {
    void apply(const StepperCommand& command);

    std::optional<stepper::SetParameters> parameters;
    std::optional<std::uint8_t> outputs = std::uint8_t{0x10};  ///< OUT5 high, the rest low (DS-S 2.3)
    std::optional<std::uint8_t> accelerationTime;    ///< of the ramp that the next smooth stop would take
    std::optional<stepper::LoadTrajectory> waiting;  ///< for a start
};

/// PIC-I/O (docs/family.md). Of masks, bit 0 is IO1.
struct IoRegisters {
    void apply(const IoCommand& command);
    /// Found as another host left it.
    void attached();
    /// What all pins are to be told so that outputs stay as they are: as they were told, otherwise as they
    /// read. Empty: nobody knows.
    [[nodiscard]] std::optional<std::uint16_t> levels(const StatusReport& latest) const {
        return outputs ? outputs : latest.pins;
    }

    std::optional<std::uint16_t> inputs = io::kAllPins;  ///< set: an input
    std::optional<std::uint16_t> outputs;                ///< what outputs were told
    std::optional<std::array<std::uint8_t, 2>> pwm = std::array<std::uint8_t, 2>{};
    std::optional<io::SetTimerMode> timer = io::SetTimerMode{};
    std::optional<io::SetSynchOutput> stored;  ///< waits for Synch Output
};

}  // namespace nmc
