// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/module/chaindiagnosis.h"

/// The chain doctor's part of the table of texts.
namespace nmc::texts {

/// The finding in one sentence.
[[nodiscard]] QString chainFinding(const ChainDiagnosis& chain);
/// What to check, and what to do then; empty if all is well or the search is still in progress.
[[nodiscard]] QString chainAdvice(const ChainDiagnosis& chain);
/// The same about a module of another version or type than expected, wherever it is reported.
[[nodiscard]] QString notExpected(ModuleIndex module);
[[nodiscard]] QString notExpectedAdvice(bool otherType);
[[nodiscard]] QString chainVerdict(ChainPlace::State verdict);
[[nodiscard]] Severity severityOf(ChainPlace::State verdict);
[[nodiscard]] Severity severityOf(ChainDiagnosis::Finding finding);
/// "Group 81", "no group".
[[nodiscard]] QString groupName(std::uint8_t group);

}  // namespace nmc::texts
