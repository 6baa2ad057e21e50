// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "widgets/scope/scopemodule.h"

/// The scope's signals in words.
namespace nmc::texts {

/// "position", "error, calculated".
[[nodiscard]] QString signalName(ScopeSignal signal);
/// "counts", "mm/s", "V".
[[nodiscard]] QString signalUnit(ScopeSignal signal, const ScopeModule& module);
/// How many decimals of a value in that unit make sense.
[[nodiscard]] int signalDecimals(ScopeSignal signal, const ScopeModule& module);
/// A value that is already in that unit, with these.
[[nodiscard]] QString signalValue(double value, ScopeSignal signal, const ScopeModule& module);
/// "0.5 s", "12 ms": a stretch of time.
[[nodiscard]] QString stretch(double seconds);

/// The data sheet's own name.
[[nodiscard]] QString bitName(const ScopeBit& bit, ModuleType type);

}  // namespace nmc::texts

namespace nmc {

/// All that have a name.
[[nodiscard]] std::vector<ScopeBit> laneBits(ModuleType type);
/// Those that tell an operator most.
[[nodiscard]] std::vector<ScopeBit> usualLaneBits(ModuleType type);

}  // namespace nmc
