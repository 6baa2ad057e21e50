// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/positionmemory.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"

namespace nmc::texts {

/// Of a position that is too old to be of now: "1.3 s old", or "out of date" below a tenth of a second.
[[nodiscard]] QString age(double seconds);
/// Where an axis was seen last, and what can be done about it.
[[nodiscard]] Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale);

namespace key {
[[nodiscard]] QString position(ModuleIndex module);
}

}  // namespace nmc::texts
