// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/time.h"
#include "protocol/moduletype.h"
#include "sim/homing.h"
#include "sim/motorplant.h"
#include "sim/pid.h"
#include "sim/stepperparameters.h"

namespace nmc::sim {

enum class ServoMode : std::uint8_t { Pwm, Velocity, Trapezoidal, StopHere };

/// What CMC and SC have beyond the first data sheet (docs/family.md).
struct LaterServoSnapshot {
    double pwm = 0;  ///< as ServoSnapshot::pwm, with the quarters of an SC's 10 bits
    unsigned pathPoints = 0;
    bool pathMode = false;
    bool fastPath = false;
    bool advancedFeatures = false;  ///< CMC only; an SC always has them
    // SC only.
    double voltSense = 0;        ///< volts at VOLT_SENSE
    bool limitStopsOff = false;  ///< action at a limit: motor off, or an abrupt stop
    bool limitStopsAbruptly = false;
    bool threePhase = false;
    bool antiphase = false;
    bool stepAndDirection = false;
    std::optional<std::uint8_t> saved;  ///< control byte of the saved configuration
};

/// Ground truth about a servo module at its last tick.
struct ServoSnapshot {
    std::int32_t position = 0;   ///< the chip's counter
    double shaftCounts = 0;      ///< the shaft itself, since the simulation began
    double commandPosition = 0;  ///< counts, including the fraction
    double positionError = 0;    ///< command - position, counts
    double commandVelocity = 0;  ///< counts per servo tick
    double velocity = 0;         ///< of the shaft, counts per servo tick; forward is positive
    double amperes = 0;          ///< motor current
    int pwm = 0;                 ///< -255..255, the sign is the direction pin
    int currentLimitAdjustment = 0;
    std::uint8_t analog = 0;                  ///< A/D converter reading
    std::optional<std::uint8_t> analogInput;  ///< set from outside; nothing: the motor's current
    bool servoOn = false;
    bool ampEnabled = false;
    bool power = false;
    ServoMode mode = ServoMode::Pwm;
    std::int32_t home = 0;
    bool limit1 = false;
    bool limit2 = false;
    bool index = false;
    bool limitsAutomatic = false;  ///< the limit pins follow the travel
    MotorParameters motor;
    std::optional<std::int64_t> homeSwitchAt;  ///< load position of the home switch at LIMIT1
    Gains gains;
    std::optional<LaterServoSnapshot> later;  ///< CMC and SC only
};

/// The starting and goal modes of the stepper's mode table (DS-S 5.1, Table 4).
enum class StepperMode : std::uint8_t { Stopped, Trapezoidal, Velocity, UnprofiledWithStop, Unprofiled };

/// Levels of a stepper's input pins. By default the switches are open and the driver has power.
struct StepperPins {
    bool estop = false;
    bool in1 = false;
    bool in2 = false;
    bool limit1 = false;  ///< forward
    bool limit2 = false;  ///< reverse
    bool homeSwitch = false;
    bool power = true;
    std::uint8_t analog = 255;  ///< TEMP_SENS: a cold motor
};

/// The shaft of a stepper, and what it operates.
struct StepperSurroundings {
    std::int64_t shaft = 0;                 ///< in steps since the simulation began
    bool limitsAutomatic = false;           ///< the limit pins follow the travel
    std::optional<std::int64_t> travelMin;  ///< hard stops, in steps of the shaft
    std::optional<std::int64_t> travelMax;
    std::optional<std::int64_t> homeSwitchAt;  ///< load position of the home switch
    std::int64_t loadPlay = 0;                 ///< steps that the shaft turns before the load follows
};

/// Ground truth about a stepper module at its last tick.
struct StepperSnapshot : StepperSurroundings {
    std::int32_t position = 0;  ///< the chip's counter
    double stepRate = 0;        ///< steps per second, negative in reverse
    unsigned speed = 0;         ///< the profile's integer speed; the nearest one in the unprofiled modes
    std::uint16_t timerCount = 0;
    StepperMode mode = StepperMode::Stopped;
    bool reverse = false;  ///< DIR
    bool moving = false;
    bool ampEnabled = false;
    std::int32_t home = 0;
    std::optional<StepperParameters> parameters;  ///< parameters in force; nothing before Set Parameters
    StepperPins inputs;
    std::uint8_t outputs = 0;       ///< bits 0 to 4: OUT1 to OUT5
    std::uint8_t currentLimit = 0;  ///< CUR_LIM, 255 is full current
};

/// What a PIC-I/O loses when it restarts. In pin masks, bit 0 is IO1 and bit 11 is IO12.
struct IoChip {
    std::uint16_t directions = 0x0FFF;  ///< a set bit means input
    std::uint16_t outputs = 0;          ///< set by Set Output
    std::array<std::uint8_t, 2> pwm{};
    std::uint16_t storedOutputs = 0;  ///< stored by Set Synch Output, like the next
    std::array<std::uint8_t, 2> storedPwm{};
    bool counting = false;   ///< timer or counter is enabled
    bool countsPin = false;  ///< counts edges of IO10 instead of time
    unsigned prescaler = 1;
    std::uint16_t latchedPins = 0;
    std::uint32_t latchedCount = 0;
};

/// The state of a PIC-I/O, its count, and the levels of its twelve pins and its A/D inputs.
struct IoSnapshot : IoChip {
    std::uint16_t levels = 0;  ///< all pins, driven by the module or from outside
    std::array<std::uint8_t, 3> analog{};
    std::uint32_t count = 0;
};

/// Ground truth about a module.
struct ModuleSnapshot {
    ModuleIdentity identity;
    std::uint8_t address = 0;
    std::uint8_t group = 0xFF;
    bool leader = false;
    double baud = 0;                 ///< UART rate, bits per second
    bool listening = false;          ///< ADDR_IN has been low and the dead time is over
    bool addressLineBroken = false;  ///< between it and its neighbour towards the host
    TimePoint time;
    std::uint64_t tick = 0;   ///< own ticks of the module since the simulation began
    std::uint8_t status = 0;  ///< status byte, without the communication error bit
    std::uint8_t pins = 0;    ///< PIC-SERVO: auxiliary status; PIC-STEP: inputs
    std::uint8_t items = 0;   ///< items set by Define Status
    Homing homing;
    ServoSnapshot servo;                     ///< servo modules only
    std::optional<StepperSnapshot> stepper;  ///< stepper modules only
    std::optional<IoSnapshot> io;            ///< PIC-I/O only
};

/// What `set` can change from outside (simulator.md, Control).
enum class Input : std::uint8_t {
    Limit1,    ///< 0 or 1
    Limit2,    ///< 0 or 1
    Index,     ///< 0 or 1, until the shaft moves
    Power,     ///< 0 or 1
    Analog,    ///< 0..255; nothing: the motor's current (servo only)
    Load,      ///< N·m
    Inertia,   ///< kg·m², > 0
    Friction,  ///< N·m, >= 0
    // Only a servo has the following inputs and the three above. Analog may be nothing only on a servo.
    Play,            ///< counts, >= 0
    CountsPerTurn,   ///< of the encoder, > 0
    Deadband,        ///< PWM counts of the amplifier, 0..254
    Gain,            ///< counts per second per PWM count, > 0
    EncoderNoise,    ///< counts rms, >= 0
    ElasticInertia,  ///< kg·m² of a second mass on a spring, >= 0
    Resonance,       ///< Hz, oscillation of shaft and second mass, > 0
    TravelMin,       ///< shaft counts (a stepper's steps), not beyond the shaft; nothing: no hard stop
    TravelMax,       ///< shaft counts (a stepper's steps), not beyond the shaft; nothing: no hard stop
    Limits,          ///< 1: the limit pins follow travel_min and travel_max; 0: they are set by hand
    HomeSwitchAt,    ///< load counts: the home switch is closed from there on forward; nothing: set by hand
    LoadPlay,        ///< counts between encoder (a stepper's shaft) and load, >= 0
    ServoOverrun,    ///< 1: as if a tick had taken too long
    // Steppers only. A stepper also has Limit1, Limit2, Power, Analog, the travel, HomeSwitchAt and LoadPlay,
    // but none of the others.
    Estop,       ///< 0 or 1
    In1,         ///< 0 or 1
    In2,         ///< 0 or 1
    HomeSwitch,  ///< 0 or 1
    // SC only.
    Pulses,     ///< number of step pulses to add, negative in reverse: -32768..32767
    VoltSense,  ///< volts, 0..5
    // PIC-I/O only; it also has Analog, numbered from 1 to 3, but none of the others.
    Pin,  ///< 0 or 1, numbered from 1 to 12
};

}  // namespace nmc::sim
