// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "widgets/scope/scopemodule.h"

/// The scope's signals in words.
namespace nmc::texts {

/// "position", "error, calculated".
[[nodiscard]] QString signalName(ScopeSignal signal);
/// As it is called on this machine, where it has a name.
[[nodiscard]] QString signalName(ScopeSignal signal, const ScopeModule& module);
/// "counts", "mm/s", "V".
[[nodiscard]] QString signalUnit(ScopeSignal signal, const ScopeModule& module);
/// The steps, in that unit, in which a value makes sense.
[[nodiscard]] double signalStep(ScopeSignal signal, const ScopeModule& module);
/// How many decimals a number has that goes in such steps.
[[nodiscard]] int decimalsAt(double step);
/// A number of a signal wherever one stands, at axes, cursors and in words: with the decimals of its step.
[[nodiscard]] QString numberAt(double value, double step);
/// "0.5 s", "12 ms": a stretch of time.
[[nodiscard]] QString stretch(double seconds);

/// The data sheet's own name.
[[nodiscard]] QString bitName(const ScopeBit& bit, ModuleType type);
/// The same, but the machine's name of a pin.
[[nodiscard]] QString bitName(const ScopeBit& bit, const ScopeModule& module);

}  // namespace nmc::texts

namespace nmc {

/// All that have a name.
[[nodiscard]] std::vector<ScopeBit> laneBits(ModuleType type);
/// Those that tell an operator most.
[[nodiscard]] std::vector<ScopeBit> usualLaneBits(ModuleType type);

}  // namespace nmc
