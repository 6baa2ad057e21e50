// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/module/homefact.h"
#include "model/settings/axisscale.h"

/// Positions that count from a work offset (model/module/homefact.h), in words. Wherever an offset is in use,
/// a position says what it counts from.
namespace nmc::texts {

using Zero = std::optional<WorkZero>;

/// "from "fixture A""
[[nodiscard]] QString from(const WorkZero& zero);
/// "10 mm from "fixture A"", or by the counter if that is not known; "10 mm" while no offset is in use.
[[nodiscard]] QString place(const Zero& zero, const AxisScale& scale, double counts);
/// "12.5 mm by the counter"; "12.5 mm" while no offset is in use.
[[nodiscard]] QString byCounter(const Zero& zero, const AxisScale& scale, double counts);
/// For a readout that changes all the time: "◇ 10.000" if it counts from an offset, or a dash for the number.
[[nodiscard]] QString marked(const Zero& zero, const AxisScale& scale, double counts);
/// What positions count from, as a sentence; empty while no offset is in use.
[[nodiscard]] QString zeroInUse(const Zero& zero);
}  // namespace nmc::texts
