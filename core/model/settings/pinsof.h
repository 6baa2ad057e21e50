// SPDX-License-Identifier: MIT
#pragma once

#include "model/settings/machine.h"

namespace nmc {

/// What was set of the pins of a PIC-I/O, to be read and to be changed; nothing was set: as they are by
/// themselves.
[[nodiscard]] inline const PinSettings& pinsOf(const AxisSettings& axis) {
    static const PinSettings none;
    return axis.pins ? *axis.pins : none;
}
[[nodiscard]] inline PinSettings& editPins(AxisSettings& axis) {
    return axis.pins ? *axis.pins : axis.pins.emplace();
}

}  // namespace nmc
