// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "model/scope/scopesignal.h"

namespace nmc {

/// The data that a plot needs of one sample, or of many that share a pixel: its begin and end, and the range
/// of each signal. NaN where a signal was unknown throughout.
struct ScopeSpan {
    struct Extremes {
        double low;
        double high;
        bool lowFirst;  ///< the lowest value came first in time
        [[nodiscard]] bool known() const { return low <= high; }
    };

    TimePoint first, last;
    double commandLow = std::numeric_limits<double>::quiet_NaN();
    double commandHigh = std::numeric_limits<double>::quiet_NaN();
    std::int32_t positionLow = 0, positionHigh = 0;
    float errorLow = ScopeSample::kUnknown, errorHigh = ScopeSample::kUnknown;
    float bandLow = ScopeSample::kUnknown, bandHigh = ScopeSample::kUnknown;  ///< band of the error
    float velocityLow = ScopeSample::kUnknown, velocityHigh = ScopeSample::kUnknown;
    std::uint8_t analogLow = 0, analogHigh = 0;
    std::uint8_t statusAll = 0, statusAny = 0;  ///< bits that were always set; bits that were set at any time
    std::uint8_t auxAll = 0, auxAny = 0;
    std::uint8_t lowFirst = 0;  ///< one bit for each of the five pairs above that are signals
    /// Data are missing immediately before this span.
    bool gapBefore : 1 = false;
    // Whether a calculated value connects with its neighbours.
    bool errorAtFirst : 1 = false;
    bool errorAtLast : 1 = false;

    [[nodiscard]] static ScopeSpan of(const ScopeSample& sample);
    /// Extends the span by `next`, which follows it.
    void add(const ScopeSpan& next);

    [[nodiscard]] Extremes extremes(ScopeSignal signal) const;
    /// True when a line may be drawn from the previous span to this one.
    [[nodiscard]] bool joins(const ScopeSpan& before, ScopeSignal signal) const {
        return !gapBefore && (!infoOf(signal).calculated || (errorAtFirst && before.errorAtLast));
    }
};

static_assert(sizeof(ScopeSpan) <= 80);

}  // namespace nmc
