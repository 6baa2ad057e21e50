// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/module/positionmemory.h"
#include "model/settings/axisscale.h"
#include "widgets/common/message.h"

namespace nmc::texts {

/// The age of a position that is not current: "1.3 s old", "out of date" below a tenth of a second, or
/// "doubtful" if it may be another module's.
[[nodiscard]] QString age(double seconds, bool doubtful);
/// Where an axis was last seen, with the offer to restore home from it.
[[nodiscard]] Message positionRemembered(const PositionMemory::Offer& offer, const AxisScale& scale);

}  // namespace nmc::texts
