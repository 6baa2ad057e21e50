// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "protocol/steppercommands.h"

namespace nmc {

/// The parameters of the command Set Parameters (DS-S 5.1).
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

/// A parameter as a number: the bits of the speed mode, an integer speed, or 0 or 1 for a choice.
[[nodiscard]] int stepperParameter(const stepper::SetParameters& parameters, StepperParameter parameter);
void setStepParameter(stepper::SetParameters& parameters, StepperParameter parameter, int value);

/// "Run current"
[[nodiscard]] QString stepperParameterName(StepperParameter parameter);
/// What it does to the motor, and what the data sheet advises (DS-S 4.5, 4.6, 5.1).
[[nodiscard]] QString stepperParameterMeaning(StepperParameter parameter);
/// What a value means, or, beside the thermal limit, the present A/D value; empty if the number is enough.
[[nodiscard]] QString stepperParameterRemark(StepperParameter parameter, std::optional<int> value,
                                             std::optional<std::uint8_t> analog);
/// "stepperRunCurrent": the object names of its controls end in "Field" and "State".
[[nodiscard]] QString stepperParameterObject(StepperParameter parameter);
/// Values to start with for an unknown motor: slow and cool. Never sent by themselves.
[[nodiscard]] stepper::SetParameters stepperStartingValues();

}  // namespace nmc
