// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/intent/intent.h"
#include "model/settings/machine.h"

/// Hold to move, whatever holds: the buttons of a panel, those of the Axes page, a gamepad. Speeds are in the
/// native unit of the module: counts per tick, or steps/s for a PIC-STEP. Pure.
namespace nmc {

struct JogRange {
    double slowest = 0.0;
    double cap = 0.0;    ///< no hold is faster; `slowest` or more
    double first = 0.0;  ///< after every connect: slow
    bool operator==(const JogRange&) const = default;
};
[[nodiscard]] JogRange jogRange(const ModuleState& module, const AxisSettings& axis);

/// The request that a held button makes: at `speed`, or at the next lower speed that the chip has. `reverse`
/// is the chip's direction. Empty while the parameters of a PIC-STEP are unknown, because the same speed
/// number then means different speeds.
[[nodiscard]] std::optional<bus::HoldToMove> jog(const ModuleState& module, const AxisSettings& axis,
                                                 double speed, bool reverse);
/// The number of another press of a button, or of what acts as one: higher than all before. GUI thread.
[[nodiscard]] std::uint32_t nextPress();
/// Why it cannot be requested now.
[[nodiscard]] std::optional<Refusal> whyNot(const bus::HoldToMove& hold, const ModuleState& module);

/// The held motion as a run that nothing ends.
[[nodiscard]] MotionSpec runOf(const bus::HoldToMove& hold);
[[nodiscard]] Pace paceOf(const bus::HoldToMove& hold);

}  // namespace nmc
