// SPDX-License-Identifier: MIT
#include "model/scope/scopespan.h"

namespace nmc {

namespace {

using Place = SignalInfo::Place;

constexpr std::uint8_t bitOf(Place place) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(place));
}

/// Extends the extremes by the span that follows. Returns true when the lowest value comes first.
template <typename Value>
bool widen(Value& low, Value& high, bool lowFirst, Value nextLow, Value nextHigh, bool nextLowFirst) {
    // A comparison with NaN is false, so a known value is kept or taken.
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
    const auto take = [&](Place place, auto& low, auto& high, auto nextLow, auto nextHigh) {
        const std::uint8_t bit = bitOf(place);
        if (widen(low, high, (lowFirst & bit) != 0, nextLow, nextHigh, (next.lowFirst & bit) != 0))
            order = static_cast<std::uint8_t>(order | bit);
    };
    take(Place::Position, positionLow, positionHigh, next.positionLow, next.positionHigh);
    take(Place::Command, commandLow, commandHigh, next.commandLow, next.commandHigh);
    take(Place::Error, errorLow, errorHigh, next.errorLow, next.errorHigh);
    take(Place::Velocity, velocityLow, velocityHigh, next.velocityLow, next.velocityHigh);
    take(Place::Analog, analogLow, analogHigh, next.analogLow, next.analogHigh);
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
    const auto made = [this](Place place, auto low, auto high, double offset = 0) -> Extremes {
        return {static_cast<double>(low) + offset, static_cast<double>(high) + offset,
                (lowFirst & bitOf(place)) != 0};
    };
    switch (infoOf(signal).place) {
        case Place::Position:
            return made(Place::Position, positionLow, positionHigh);
        case Place::Counter:
            return made(Place::Position, positionLow, positionHigh, ScopeSample::kTopBit);
        case Place::Command:
            return made(Place::Command, commandLow, commandHigh);
        case Place::Error:
            return made(Place::Error, errorLow, errorHigh);
        case Place::Velocity:
            return made(Place::Velocity, velocityLow, velocityHigh);
        case Place::Analog:
            return made(Place::Analog, analogLow, analogHigh);
        case Place::Derived:
            break;
    }
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, false};
}

}  // namespace nmc
