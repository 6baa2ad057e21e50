// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "widgets/scope/scopemodule.h"

/// The scope's signals in words.
namespace nmc::texts {

/// "position", "position error, calculated".
[[nodiscard]] QString signalName(ScopeSignal signal);
/// "counts", "mm/s", "V".
[[nodiscard]] QString signalUnit(ScopeSignal signal, const ScopeModule& module);
/// A value that is already in that unit, with as many digits as make sense.
[[nodiscard]] QString signalValue(double value, ScopeSignal signal, const ScopeModule& module);
/// "0.5 s", "12 ms": a stretch of time.
[[nodiscard]] QString stretch(double seconds);

}  // namespace nmc::texts

namespace nmc {

/// A bit of a module's two status bytes.
struct LaneBit {
    bool second = false;  ///< auxiliary status; inputs of a PIC-STEP
    int bit = 0;
    auto operator<=>(const LaneBit&) const = default;
};

namespace texts {
/// The data sheet's own name.
[[nodiscard]] QString bitName(const LaneBit& bit, ModuleType type);
}  // namespace texts

/// All that have a name.
[[nodiscard]] std::vector<LaneBit> laneBits(ModuleType type);
/// Those that tell an operator most.
[[nodiscard]] std::vector<LaneBit> usualLaneBits(ModuleType type);

}  // namespace nmc
