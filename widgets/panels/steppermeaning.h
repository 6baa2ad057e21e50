// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "protocol/steppercommands.h"

namespace nmc {

/// What Set Parameters takes (DS-S 5.1).
enum class StepperParameter : std::uint8_t {
    SpeedMode,
    MinimumSpeed,
    RunCurrent,
    HoldCurrent,
    ThermalLimit,
    IgnoreLimits,
    IgnoreEstop,
    MotorOff
};
inline constexpr std::array<StepperParameter, 8> kStepperParameters{
    StepperParameter::SpeedMode,   StepperParameter::MinimumSpeed, StepperParameter::RunCurrent,
    StepperParameter::HoldCurrent, StepperParameter::ThermalLimit, StepperParameter::IgnoreLimits,
    StepperParameter::IgnoreEstop, StepperParameter::MotorOff};

/// As a number: the bits of the speed mode, an integer speed, 0 or 1 of a choice.
[[nodiscard]] int stepperParameter(const stepper::SetParameters& parameters, StepperParameter parameter);
void setStepParameter(stepper::SetParameters& parameters, StepperParameter parameter, int value);

/// "Run current"
[[nodiscard]] QString stepperParameterName(StepperParameter parameter);
/// What it does to the motor, and what the data sheet advises (DS-S 4.5, 4.6, 5.1).
[[nodiscard]] QString stepperParameterMeaning(StepperParameter parameter);
/// What a value comes to, and the live A/D value beside its limit; empty where the number says it all.
[[nodiscard]] QString stepperParameterRemark(StepperParameter parameter, std::optional<int> value,
                                             std::optional<std::uint8_t> analog);
/// "stepperRunCurrent": its controls are called "...Field" and "...State".
[[nodiscard]] QString stepperParameterObject(StepperParameter parameter);
/// Where to begin with a motor that nothing is known of: slow and cool. Never sent by themselves.
[[nodiscard]] stepper::SetParameters stepperStartingValues();

}  // namespace nmc
