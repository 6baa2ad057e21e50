// SPDX-License-Identifier: MIT
#pragma once

#include "model/settings/machine.h"

namespace nmc {

/// The pin settings of a PIC-I/O, for reading and for changing; the defaults if nothing was set.
[[nodiscard]] inline const PinSettings& pinsOf(const AxisSettings& axis) {
    static const PinSettings none;
    return axis.pins ? *axis.pins : none;
}
[[nodiscard]] inline PinSettings& editPins(AxisSettings& axis) {
    return axis.pins ? *axis.pins : axis.pins.emplace();
}

}  // namespace nmc
