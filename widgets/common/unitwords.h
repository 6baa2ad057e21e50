// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "model/module/swingwatch.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {
struct ModuleState;
}

/// Numbers of an axis in words, in the user's unit.
namespace nmc::texts {

/// "counts", "turns", "°", "mm", or the user's own.
[[nodiscard]] QString unitOf(const AxisScale& scale);
/// "counts/tick" (PIC-STEP: "steps/s"), or the user's unit per second.
[[nodiscard]] QString velocityUnitOf(const AxisScale& scale);
/// "counts/s", "turns/s": the unit of a measured speed, whatever the chip's own unit is.
[[nodiscard]] QString measuredVelocityUnitOf(const AxisScale& scale);
/// "1 953 counts/s", "12.50 mm/s": a measured speed, passed in counts (steps) per second; with a fixed number
/// of decimals.
[[nodiscard]] QString measuredVelocity(const AxisScale& scale, double countsPerSecond);
[[nodiscard]] QString accelerationUnitOf(const AxisScale& scale);
/// "0.9766 turns/s", from a native number; "1 counts/tick" if the scale is not timed(), since nothing else is
/// known.
[[nodiscard]] QString velocity(const AxisScale& scale, double native, int significant = 4);
[[nodiscard]] QString acceleration(const AxisScale& scale, double native);
/// The digits of a readout that changes all the time: always with the number of decimals that a count
/// resolves.
[[nodiscard]] QString fixedPosition(const AxisScale& scale, double counts);
/// The number of decimals that a count resolves.
[[nodiscard]] int positionDecimals(const AxisScale& scale);
/// "1 234 counts", "0.617 turns".
[[nodiscard]] QString position(const AxisScale& scale, double counts);
/// An amount without a direction: "1 234 counts".
[[nodiscard]] QString distance(const AxisScale& scale, double counts);
/// For a servo that should hold: "Oscillating ± 200 counts at about 37 Hz"
[[nodiscard]] QString swing(const SwingWatch::Swing& swing, const AxisScale& scale);
/// What the module is doing, in a few words: "At speed", "Holding, oscillating", "Holding, 24 counts off".
[[nodiscard]] QString activity(const ModuleState& module, const AxisScale& scale);
/// What the module is doing, as a sentence that says what it means.
[[nodiscard]] QString activityMeaning(const ModuleState& module, const AxisScale& scale);
/// A native number in the unit that its field does not have: "= 977 counts/s" beside counts/tick, "= 0.5
/// counts/tick" beside turns/s, "= – counts/s" while SR is unknown. Empty if there is no other unit.
[[nodiscard]] QString otherPosition(const AxisScale& scale, double counts);
[[nodiscard]] QString otherVelocity(const AxisScale& scale, double nativeVelocity);
[[nodiscard]] QString otherAcceleration(const AxisScale& scale, double nativeAcceleration);

/// "1.98 V": what an A/D value stands for.
[[nodiscard]] QString analog(const AnalogScale& scale, int value);
/// What an A/D value stands for, with the value itself: "1.98 V (101 of 255)", or "–".
[[nodiscard]] QString analogReading(const AnalogScale& scale, std::optional<int> value);

}  // namespace nmc::texts
