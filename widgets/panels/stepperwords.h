// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/settings/machine.h"
#include "module/stepperspeed.h"

/// Texts that say what a PIC-STEP makes of the numbers that the user typed.
namespace nmc::texts {

/// "1x: 25 to 6 250 steps/s"
[[nodiscard]] QString speedMode(stepper::SpeedMode mode);
/// "Runs at 1 200 steps/s (2.4 mm/s): speed 48 of 250."
[[nodiscard]] QString profiledSpeed(const StepperSpeed& mode, int speed, int minimum, const AxisScale& scale);
/// "Runs at 1 199.6 steps/s: timer count 65 017."
[[nodiscard]] QString timedSpeed(const StepperSpeed& mode, stepper::TimerCount timer, const AxisScale& scale);
/// "2 500 steps/s²", followed by the value in the user's unit if that is a different one.
[[nodiscard]] QString acceleration(const StepperSpeed& mode, int accelerationTime, const AxisScale& scale);
/// "Ramp of 2 500 steps/s²."
[[nodiscard]] QString ramp(const StepperSpeed& mode, int accelerationTime, const AxisScale& scale);
/// "Takes 2.35 s, peak speed 1 200 steps/s."
[[nodiscard]] QString forecast(const StepperForecast& forecast, const AxisScale& scale);
/// "1 200 steps/s", followed by the value in the user's unit if that is a different one.
[[nodiscard]] QString stepsPerSecond(double speed, const AxisScale& scale);

}  // namespace nmc::texts
