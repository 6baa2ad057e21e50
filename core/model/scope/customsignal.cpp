// SPDX-License-Identifier: MIT
#include "model/scope/customsignal.h"

#include <cmath>
#include <numbers>

namespace nmc {

std::optional<ScopeSample> CustomSignalMaker::take(const ScopeSample& sample, ScopeSignal signal,
                                                   const SignalSource& second) {
    const auto value = valueAt(sample, signal, second);
    if (sample.gapBefore || !value)
        m_last.reset();
    if (!value)
        return std::nullopt;
    // Exact for a value that has held since the last sample, however far apart the samples are.
    const double share =
        m_last && m_how.cutoff > 0
            ? -std::expm1(-2 * std::numbers::pi * m_how.cutoff * toSeconds(sample.time - *m_last))
            : 1.0;
    m_filtered = share < 1 ? m_filtered + share * (*value - m_filtered) : *value;
    const bool gap = !m_last;
    m_last = sample.time;
    return derivedValue(sample.time, m_filtered, m_filtered, m_filtered, gap);
}

std::optional<double> CustomSignalMaker::valueAt(const ScopeSample& sample, ScopeSignal signal,
                                                 const SignalSource& second) const {
    const auto first = valueOf(sample, signal);
    if (!first || !m_how.second)
        return first ? std::optional(m_how.first.scale(*first)) : std::nullopt;
    const auto other = second.samples->valueAt(sample.time, second.signal);
    return other ? std::optional(m_how.first.scale(*first) + m_how.second->scale(*other)) : std::nullopt;
}

}  // namespace nmc
