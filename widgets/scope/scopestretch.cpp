// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopestretch.h"

#include <algorithm>

namespace nmc {

ScopeStretch stretchOf(const ScopePlot::Trace& trace, const CursorTimes& times, const SignalSource& source,
                       TimePoint zero) {
    const auto last = source.samples->last();
    const bool open = !last || last->time < zero + fromSeconds(std::max(times[0], times[1]));
    return {{trace.module, trace.signal},
            trace.scale,
            times,
            zero,
            source,
            open ? source.samples->count() : UINT64_MAX};
}

bool ScopeStretch::read(std::vector<SignalPoint>& points) const {
    points.clear();
    const auto [first, last] = std::minmax(times[0], times[1]);
    const TimePoint from = zero + fromSeconds(first);
    // Where samples are kept only in a coarser form, only their extremes are known.
    if (const auto since = source.samples->keptSince();
        !since || (*since > from && *source.samples->begin() < *since))
        return false;
    bool known = false;
    source.samples->visitKept(from, zero + fromSeconds(last), [&](const ScopeSample& sample) {
        const auto value = valueOf(sample, source.signal);
        if (value)
            points.push_back({toSeconds(sample.time - zero), scale(*value), known && !sample.gapBefore});
        known = value.has_value();
    });
    return true;
}

}  // namespace nmc
