// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"
#include "model/procedure/homingrun.h"

namespace nmc {

/// Approaches a switch, or the encoder's index, from both sides as often as requested, with the chip's own
/// capture, and reports where it changed (model/procedure/repeatability.h). Home stays what it was, and the
/// motor is at rest beyond the switch at the end.
///
/// A switch is approached where it closes and, in the other direction, where it opens: its other edge, if it
/// has one, must be farther away than a smooth stop takes the motor. Before each approach the motor has moved
/// on in the previous direction by the distance of that stop, so it is up to speed again at the switch.
class RepeatabilityRun : public HomingRun {
public:
    /// `wanted` must be possible now.
    RepeatabilityRun(const intent::MeasureRepeatability& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next found(const HomingLook& seen, TimePoint now) override;
    [[nodiscard]] bool leavesFirst(const HomingLook& seen) const override;

    bool m_reverse;  ///< the direction in which the switch closes
};

}  // namespace nmc
