// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/scope/history.h"
#include "model/scope/linearscale.h"

namespace nmc {

/// A signal that the user has defined: one signal, or the sum of two of any modules, each with a scale, and
/// then through a low-pass filter of the first order.
struct CustomSignal {
    struct Part {
        ModuleSignal of;  ///< not itself a custom signal
        LinearScale scale{};
        bool operator==(const Part&) const = default;
    };
    ModuleSignal of;  ///< its own place: the module for which it is shown, and which of the user's it is
    Part first;
    std::optional<Part> second{};
    double cutoff = 0.0;  ///< Hz; 0: no filter
    bool operator==(const CustomSignal&) const = default;
};

/// A signal in a history; `samples` is null where there are none.
struct SignalSource {
    const ModuleHistory* samples = nullptr;
    ScopeSignal signal = ScopeSignal::Position;
    /// For a derived signal, a number that changes whenever its values are recomputed: the new ones may be at
    /// the same address.
    std::uint64_t number = 0;
    bool operator==(const SignalSource&) const = default;
};

/// Computes the values of a custom signal, one for each sample of its first part; between two samples of its
/// second part, that is interpolated. A value is unknown, and leaves a gap, where a part is unknown. Pure.
class CustomSignalMaker {
public:
    explicit CustomSignalMaker(const CustomSignal& how) : m_how(how) {}

    [[nodiscard]] const CustomSignal& how() const { return m_how; }
    /// The value at a sample of the first part, in the form of a calculated error. Samples must be in order
    /// of time, and none later than the last one of the second part.
    [[nodiscard]] std::optional<ScopeSample> take(const ScopeSample& sample, ScopeSignal signal,
                                                  const SignalSource& second);

private:
    [[nodiscard]] std::optional<double> valueAt(const ScopeSample& sample, ScopeSignal signal,
                                                const SignalSource& second) const;

    CustomSignal m_how;
    std::optional<TimePoint> m_last;  ///< of the last value, if this one continues it
    double m_filtered = 0.0;
};

}  // namespace nmc
