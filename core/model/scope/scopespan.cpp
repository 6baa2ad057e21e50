// SPDX-License-Identifier: MIT
#include "model/scope/scopespan.h"

namespace nmc {

namespace {

constexpr std::uint8_t bitOf(ScopeSignal signal) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(signal));
}

/// Takes in what follows. Returns whether the lowest comes first.
template <typename Value>
bool widen(Value& low, Value& high, bool lowFirst, Value nextLow, Value nextHigh, bool nextLowFirst) {
    // A comparison with NaN is false: the known one of the two stays or is taken.
    const bool lower = nextLow < low || low != low;
    const bool higher = nextHigh > high || high != high;
    if (lower)
        low = nextLow;
    if (higher)
        high = nextHigh;
    if (lower && higher)
        return nextLowFirst;
    return lower ? false : higher ? true : lowFirst;
}

}  // namespace

ScopeSpan ScopeSpan::of(const ScopeSample& sample) {
    ScopeSpan span;
    span.first = span.last = sample.time;
    span.commandLow = span.commandHigh = sample.command();
    span.positionLow = span.positionHigh = sample.position;
    span.errorLow = span.errorHigh = sample.error;
    span.bandLow = sample.errorLow;
    span.bandHigh = sample.errorHigh;
    span.velocityLow = span.velocityHigh = sample.velocity;
    span.analogLow = span.analogHigh = sample.analog;
    span.statusAll = span.statusAny = sample.status;
    span.auxAll = span.auxAny = sample.aux;
    span.lowFirst = 0xFF;
    span.gapBefore = sample.gapBefore;
    span.errorAtFirst = span.errorAtLast = sample.errorKnown();
    return span;
}

void ScopeSpan::add(const ScopeSpan& next) {
    std::uint8_t order = 0;
    const auto take = [&](ScopeSignal signal, auto& low, auto& high, auto nextLow, auto nextHigh) {
        const std::uint8_t bit = bitOf(signal);
        if (widen(low, high, (lowFirst & bit) != 0, nextLow, nextHigh, (next.lowFirst & bit) != 0))
            order = static_cast<std::uint8_t>(order | bit);
    };
    take(ScopeSignal::Position, positionLow, positionHigh, next.positionLow, next.positionHigh);
    take(ScopeSignal::Command, commandLow, commandHigh, next.commandLow, next.commandHigh);
    take(ScopeSignal::Error, errorLow, errorHigh, next.errorLow, next.errorHigh);
    take(ScopeSignal::Velocity, velocityLow, velocityHigh, next.velocityLow, next.velocityHigh);
    take(ScopeSignal::Analog, analogLow, analogHigh, next.analogLow, next.analogHigh);
    lowFirst = order;
    widen(bandLow, bandHigh, true, next.bandLow, next.bandHigh, true);
    statusAll &= next.statusAll;
    statusAny |= next.statusAny;
    auxAll &= next.auxAll;
    auxAny |= next.auxAny;
    errorAtLast = next.errorAtLast;
    last = next.last;
}

ScopeSpan::Extremes ScopeSpan::extremes(ScopeSignal signal) const {
    const bool order = (lowFirst & bitOf(signal)) != 0;
    switch (signal) {
        case ScopeSignal::Position:
            return {static_cast<double>(positionLow), static_cast<double>(positionHigh), order};
        case ScopeSignal::Command:
            return {commandLow, commandHigh, order};
        case ScopeSignal::Error:
            return {static_cast<double>(errorLow), static_cast<double>(errorHigh), order};
        case ScopeSignal::Velocity:
            return {static_cast<double>(velocityLow), static_cast<double>(velocityHigh), order};
        case ScopeSignal::Analog:
            return {static_cast<double>(analogLow), static_cast<double>(analogHigh), order};
        case ScopeSignal::Acceleration:
        case ScopeSignal::Pwm:
            break;
    }
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, false};
}

}  // namespace nmc
