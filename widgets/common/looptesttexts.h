// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/textparts.h"

namespace nmc::texts {

/// Of a test of a loop (isTest) that has failed. `who`: "Module 1".
[[nodiscard]] Words testFailed(const ProcedureReport& report, const QString& who);

}  // namespace nmc::texts
