// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/textparts.h"

namespace nmc::texts {

/// Says that a loop test (isTest()) has failed, and why. `who`: "Module 1".
[[nodiscard]] Words testFailed(const ProcedureReport& report, const QString& who);

}  // namespace nmc::texts
