// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/module/swingwatch.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {
struct ModuleState;
}

/// Numbers of an axis in words, in the unit that its user reads it in.
namespace nmc::texts {

/// "counts", "turns", "°", "mm", or the user's own.
[[nodiscard]] QString unitOf(const AxisScale& scale);
/// "counts/tick" (PIC-STEP: "steps/s"), or the user's unit per second.
[[nodiscard]] QString velocityUnitOf(const AxisScale& scale);
/// "counts/s", "turns/s": of a speed that was measured, whatever the chip counts in.
[[nodiscard]] QString measuredVelocityUnitOf(const AxisScale& scale);
/// "1 953 counts/s", "12.50 mm/s": a speed that was measured, in counts (steps) a second; always as many
/// decimals.
[[nodiscard]] QString measuredVelocity(const AxisScale& scale, double countsPerSecond);
[[nodiscard]] QString accelerationUnitOf(const AxisScale& scale);
/// "0.9766 turns/s" of a native number; "1 counts/tick", which is all that is known of it, unless the scale
/// is timed().
[[nodiscard]] QString velocity(const AxisScale& scale, double native, int significant = 4);
[[nodiscard]] QString acceleration(const AxisScale& scale, double native);
/// Digits for a readout that changes all the time: as many decimals as counts can tell apart, always.
[[nodiscard]] QString fixedPosition(const AxisScale& scale, double counts);
/// How many decimals that is.
[[nodiscard]] int positionDecimals(const AxisScale& scale);
/// "1 234 counts", "0.617 turns".
[[nodiscard]] QString position(const AxisScale& scale, double counts);
/// An amount without a direction: "1 234 counts".
[[nodiscard]] QString distance(const AxisScale& scale, double counts);
/// Of a servo that should hold: "Oscillating ± 200 counts at about 37 Hz"
[[nodiscard]] QString swing(const SwingWatch::Swing& swing, const AxisScale& scale);
/// What it is doing in a few words: "Moving", "Holding, oscillating", "Holding, 24 counts off".
[[nodiscard]] QString activity(const ModuleState& module, const AxisScale& scale);
/// The same as a sentence that says what to make of it.
[[nodiscard]] QString activityMeaning(const ModuleState& module, const AxisScale& scale);
/// A native number in the view that a field does not have: "= 977 counts/s" beside counts/tick, "= 0.5
/// counts/tick" beside turns/s, "= – counts/s" while SR is not known. Empty where there is only one view.
[[nodiscard]] QString otherPosition(const AxisScale& scale, double counts);
[[nodiscard]] QString otherVelocity(const AxisScale& scale, double nativeVelocity);
[[nodiscard]] QString otherAcceleration(const AxisScale& scale, double nativeAcceleration);

/// "1.98 V": what an A/D value stands for.
[[nodiscard]] QString analog(const AnalogScale& scale, int value);
/// The same with the number itself: "1.98 V (101 of 255)".
[[nodiscard]] QString analogReading(const AnalogScale& scale, int value);

}  // namespace nmc::texts
