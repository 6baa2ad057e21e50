// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "protocol/stepcommands.h"

namespace nmc {

/// What Set Parameters takes (DS-S 5.1).
enum class StepParameter : std::uint8_t {
    SpeedMode,
    MinimumSpeed,
    RunCurrent,
    HoldCurrent,
    ThermalLimit,
    IgnoreLimits,
    IgnoreEstop,
    MotorOff
};
inline constexpr std::array<StepParameter, 8> kStepParameters{
    StepParameter::SpeedMode,   StepParameter::MinimumSpeed, StepParameter::RunCurrent,
    StepParameter::HoldCurrent, StepParameter::ThermalLimit, StepParameter::IgnoreLimits,
    StepParameter::IgnoreEstop, StepParameter::MotorOff};

/// As a number: the bits of the speed mode, an integer speed, 0 or 1 of a choice.
[[nodiscard]] int stepParameter(const step::SetParameters& parameters, StepParameter parameter);
void setStepParameter(step::SetParameters& parameters, StepParameter parameter, int value);

/// "Run current"
[[nodiscard]] QString stepParameterName(StepParameter parameter);
/// What it does to the motor, and what the data sheet advises (DS-S 4.5, 4.6, 5.1).
[[nodiscard]] QString stepParameterMeaning(StepParameter parameter);
/// What a value comes to, and the live A/D value beside its limit; empty where the number says it all.
[[nodiscard]] QString stepParameterRemark(StepParameter parameter, std::optional<int> value,
                                          std::optional<std::uint8_t> analog);
/// "stepRunCurrent": its controls are called "...Field" and "...State".
[[nodiscard]] QString stepParameterObject(StepParameter parameter);
/// Where to begin with a motor that nothing is known of: slow and cool. Never sent by themselves.
[[nodiscard]] step::SetParameters stepStartingValues();

}  // namespace nmc
