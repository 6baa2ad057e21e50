// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/positionmemory.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"

namespace nmc::texts {

/// Where an axis was seen last, and what can be done about it.
[[nodiscard]] Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale);

namespace key {
[[nodiscard]] QString position(ModuleIndex module);
}

}  // namespace nmc::texts
