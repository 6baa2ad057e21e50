// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "base/strong.h"
#include "model/scope/countrate.h"
#include "model/scope/gainschange.h"
#include "model/scope/measuredacceleration.h"
#include "model/scope/pwmoutput.h"
#include "model/scope/scopesignal.h"

namespace nmc {

/// A signal of a module.
struct ModuleSignal {
    ModuleIndex module;
    ScopeSignal signal = ScopeSignal::Position;
    bool operator==(const ModuleSignal&) const = default;
};

/// Computes the values of a signal that no sample contains, from its module's samples as they arrive. Pure.
class SignalMaker {
public:
    /// A value belongs to a moment before the sample that completes it: at most this many samples before, or
    /// this time before if that is longer.
    static constexpr std::size_t kSamplesBehind = MeasuredAcceleration::kFewest;
    static constexpr Duration kTimeBehind = MeasuredAcceleration::kTime;

    /// `of` must be a derived signal, but not a custom one.
    explicit SignalMaker(const ModuleSignal& of);

    [[nodiscard]] const ModuleSignal& of() const { return m_of; }
    /// Samples must be in order of time; `gains` are all known gains, always of the same history. Returns
    /// nothing when there is no value yet, or it is unknown; otherwise as derivedValue().
    [[nodiscard]] std::optional<ScopeSample> take(const ScopeSample& sample,
                                                  const std::vector<GainsChange>& gains);

private:
    ModuleSignal m_of;
    std::size_t m_gainsTaken = 0;
    std::optional<servo::SetGain> m_gains;
    std::variant<MeasuredAcceleration, PwmOutput, CountRate> m_maker;
};

}  // namespace nmc
