// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "model/scope/stretchfigures.h"
#include "widgets/scope/scopeplot.h"

namespace nmc {

/// The samples of a signal between the two cursors. Two are equal if they hold the same samples. Valid while
/// the history is.
struct ScopeStretch {
    ModuleSignal of;
    LinearScale scale{};
    CursorTimes times{};
    TimePoint zero{};
    SignalSource source{};
    std::uint64_t samples = 0;  ///< that have arrived so far, as long as more may arrive between the cursors

    /// Reads them into `points`, in the unit of the scale. Returns false, and no points, if they are no
    /// longer kept individually.
    [[nodiscard]] bool read(std::vector<SignalPoint>& points) const;
    bool operator==(const ScopeStretch&) const = default;
};

/// `source`: must have samples.
[[nodiscard]] ScopeStretch stretchOf(const ScopePlot::Trace& trace, const CursorTimes& times,
                                     const SignalSource& source, TimePoint zero);

}  // namespace nmc
