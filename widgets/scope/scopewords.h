// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>
#include <vector>

#include "widgets/scope/scopemodule.h"

/// The scope's signals in words.
namespace nmc::texts {

/// "position", "error, calculated".
[[nodiscard]] QString signalName(ScopeSignal signal);
/// Its name on this machine, if it has one; "error, reported" where the chip reports the error.
[[nodiscard]] QString signalName(ScopeSignal signal, const ScopeModule& module);
/// "counts", "mm/s", "V".
[[nodiscard]] QString signalUnit(ScopeSignal signal, const ScopeModule& module);
/// The step, in the unit of signalUnit(), in which its values are meaningful.
[[nodiscard]] double signalStep(ScopeSignal signal, const ScopeModule& module);
/// Number of decimals of a value that changes in steps of `step`.
[[nodiscard]] int decimalsAt(double step);
/// A value of a signal with the decimals of its step, for axes, cursors and sentences.
[[nodiscard]] QString numberAt(double value, double step);
/// "0.5 s", "12 ms": a stretch of time.
[[nodiscard]] QString stretch(double seconds);

/// The name in the data sheet.
[[nodiscard]] QString bitName(const ScopeBit& bit, const ModuleIdentity& module);
/// For a pin, its name on this machine if it has one; otherwise the name in the data sheet.
[[nodiscard]] QString bitName(const ScopeBit& bit, const ScopeModule& module);

}  // namespace nmc::texts

namespace nmc {

/// For texts of the scope that belong to none of its classes.
class ScopeTexts {
    Q_DECLARE_TR_FUNCTIONS(Scope)
};

/// All bits that have a name.
[[nodiscard]] std::vector<ScopeBit> laneBits(const ModuleIdentity& module);
/// The bits that are most useful to an operator.
[[nodiscard]] std::vector<ScopeBit> usualLaneBits(ModuleType type);

}  // namespace nmc
