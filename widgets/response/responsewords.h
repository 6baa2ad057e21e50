// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "model/intent/responsetaken.h"
#include "model/module/pwmdemand.h"
#include "model/response/responsemetrics.h"
#include "model/settings/axisscale.h"

/// Step responses in words.
namespace nmc::texts {

[[nodiscard]] QString responseMethod(ResponseMethod method);
/// What the motor is told, one sentence.
[[nodiscard]] QString responseMethodMeaning(ResponseMethod method);

/// "12.3 ± 0.4 ms": with as many digits as the doubt leaves a meaning.
[[nodiscard]] QString plusMinus(const Measured& measured, const QString& unit);
/// The same without a unit.
[[nodiscard]] QString plusMinus(const Measured& measured);
// The same, or why it could not be measured.
[[nodiscard]] QString responseTime(const ResponseMetrics::Result<Measured>& seconds);
/// In a few words: to the goal, or else beside it.
[[nodiscard]] QString responseSettling(const ResponseMetrics& metrics);
[[nodiscard]] QString responseOvershoot(const ResponseMetrics::Result<Measured>& percent);
[[nodiscard]] QString responseError(const ResponseMetrics::Result<Measured>& counts, const AxisScale& scale);
/// "limited to 127", "at least 23", "unknown"; of 255.
[[nodiscard]] QString peakPwm(const std::optional<PwmDemand>& demand);

}  // namespace nmc::texts
