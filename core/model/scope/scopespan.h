// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "model/scope/scopesignal.h"

namespace nmc {

/// What a plot needs of one sample, or of many that share a pixel: where it begins and ends, and how far each
/// signal went. NaN where nothing was known throughout.
struct ScopeSpan {
    struct Extremes {
        double low;
        double high;
        bool lowFirst;  ///< in the order of time
        [[nodiscard]] bool known() const { return low <= high; }
    };

    TimePoint first, last;
    double commandLow = std::numeric_limits<double>::quiet_NaN();
    double commandHigh = std::numeric_limits<double>::quiet_NaN();
    std::int32_t positionLow = 0, positionHigh = 0;
    float errorLow = ScopeSample::kUnknown, errorHigh = ScopeSample::kUnknown;
    float bandLow = ScopeSample::kUnknown, bandHigh = ScopeSample::kUnknown;  ///< of the error
    float velocityLow = ScopeSample::kUnknown, velocityHigh = ScopeSample::kUnknown;
    std::uint8_t analogLow = 0, analogHigh = 0;
    std::uint8_t statusAll = 0, statusAny = 0;  ///< bits that were set all the time; at any time
    std::uint8_t auxAll = 0, auxAny = 0;
    std::uint8_t lowFirst = 0;  ///< a bit for each of the five pairs above that are signals
    /// Data is missing right before.
    bool gapBefore : 1 = false;
    // Whether a calculated value joins on to its neighbours.
    bool errorAtFirst : 1 = false;
    bool errorAtLast : 1 = false;

    [[nodiscard]] static ScopeSpan of(const ScopeSample& sample);
    /// `next` follows this one.
    void add(const ScopeSpan& next);

    [[nodiscard]] Extremes extremes(ScopeSignal signal) const;
    /// A line may be drawn from the span before to this one.
    [[nodiscard]] bool joins(const ScopeSpan& before, ScopeSignal signal) const {
        return !gapBefore && (!isCalculated(signal) || (errorAtFirst && before.errorAtLast));
    }
};

static_assert(sizeof(ScopeSpan) <= 80);

}  // namespace nmc
