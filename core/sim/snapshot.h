// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "base/time.h"
#include "protocol/moduletype.h"
#include "sim/pid.h"

namespace nmc::sim {

enum class ServoMode : std::uint8_t { Pwm, Velocity, Trapezoidal, StopHere };

/// "pwm", "velocity", "trapezoidal", "stop-here".
[[nodiscard]] std::string_view toText(ServoMode mode);

/// Ground truth about a servo module at its last tick.
struct ServoSnapshot {
    std::int32_t position = 0;   ///< the chip's counter
    double shaftCounts = 0;      ///< the shaft itself, since the simulation began
    double commandPosition = 0;  ///< counts, with its fraction
    double positionError = 0;    ///< command - position, counts
    double commandVelocity = 0;  ///< counts per servo tick
    double velocity = 0;         ///< of the shaft, counts per maximum-rate tick; forward is positive
    double amperes = 0;          ///< motor current
    int pwm = 0;                 ///< -255..255, the sign is the direction pin
    int currentLimitAdjustment = 0;
    std::uint8_t analog = 0;  ///< what the A/D converter reads
    bool servoOn = false;
    bool ampEnabled = false;
    bool power = false;
    ServoMode mode = ServoMode::Pwm;
    std::int32_t home = 0;
    bool limit1 = false;
    bool limit2 = false;
    bool index = false;
    bool limitsAutomatic = false;  ///< the limit pins follow the travel
    Gains gains;
};

/// Ground truth about a module.
struct ModuleSnapshot {
    ModuleIdentity identity;
    std::uint8_t address = 0;
    std::uint8_t group = 0xFF;
    bool leader = false;
    std::uint8_t brd = 0;    ///< divisor of its UART
    bool listening = false;  ///< ADDR_IN has been low and the dead time is over
    TimePoint time;
    std::uint64_t tick = 0;  ///< its own ticks since the simulation began
    ServoSnapshot servo;     ///< of a servo module only
};

/// What `set` can change from outside (simulator.md, Control).
enum class Input : std::uint8_t {
    Limit1,     ///< 0 or 1
    Limit2,     ///< 0 or 1
    Index,      ///< 0 or 1, until the shaft moves on
    Power,      ///< 0 or 1
    Analog,     ///< 0..255; nothing: the motor's current
    Load,       ///< N·m
    Inertia,    ///< kg·m², > 0
    Friction,   ///< N·m, >= 0
    TravelMin,  ///< shaft counts, not beyond the shaft; nothing: none
    TravelMax,  ///< shaft counts, not beyond the shaft; nothing: none
    Limits,     ///< 1: limit 1 and 2 follow travel_min and travel_max, 0: they are set
};

}  // namespace nmc::sim
