// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/response/responserecord.h"

namespace nmc {

/// Edges of a square wave laid over one another: the sample times relative to each edge interleave, so that N
/// edges are sampled N times as finely as one. A time slot holds the samples that fall into it.
struct FoldedPoint {
    double seconds = 0.0;   ///< mean time of the slot's samples since the edge
    double position = 0.0;  ///< median, in counts from where the edge began
    double low = 0.0;       ///< a tenth of the samples are below this
    double high = 0.0;      ///< a tenth of the samples are above this
    unsigned samples = 0;
};

struct EdgeFold {
    std::vector<FoldedPoint> points;
    ResponseRecord run;  ///< the median as one step response, measured like any other
};

/// Folds the edges in one direction that have the same gains as the last of them. `forward`: towards higher
/// counts. Time slots are as narrow as the samples permit, but not narrower than a servo tick. Returns
/// nothing if there are none. Pure.
[[nodiscard]] std::optional<EdgeFold> foldEdges(std::span<const ResponseRecord> edges, bool forward);

}  // namespace nmc
