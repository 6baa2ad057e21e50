// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"

/// Step responses in words.
namespace nmc::texts {

[[nodiscard]] QString responseMethod(ResponseMethod method);
/// What the method commands, in one or two sentences.
[[nodiscard]] QString responseMethodMeaning(ResponseMethod method);

/// "12.3 ± 0.4 ms": with as many digits as the uncertainty justifies.
[[nodiscard]] QString plusMinus(const Measured& measured, const QString& unit);
/// "12.3 ± 0.4", without a unit.
[[nodiscard]] QString plusMinus(const Measured& measured);
// The value with its uncertainty, or why it could not be measured.
[[nodiscard]] QString responseTime(const Figure& seconds);
/// Time to settle at the goal or, if it did not, at its rest position; of a profiled move, after its profile.
[[nodiscard]] QString responseSettling(const ResponseRecord& run);
/// The shortest and the longest settling time of moves that were made together.
[[nodiscard]] QString settlingSpread(const std::vector<const KeptResponse*>& moves);
[[nodiscard]] QString responseOvershoot(const Figure& percent);
[[nodiscard]] QString responseError(const Figure& counts, const AxisScale& scale);
/// Of an error without its sign.
[[nodiscard]] QString responseErrorSize(const Figure& counts, const AxisScale& scale);
/// "limited to 127", "at least 23", "unknown"; of 255.
[[nodiscard]] QString peakPwm(const std::optional<PwmDemand>& demand);

}  // namespace nmc::texts
