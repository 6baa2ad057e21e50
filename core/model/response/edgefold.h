// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/response/responserecord.h"

namespace nmc {

/// Some edges of a square wave laid over one another: the times since each of them interleave, so that N of
/// them are sampled N times as finely as one. A place of time has the samples that fall into it.
struct FoldedPoint {
    double seconds = 0.0;   ///< since the edge, mean of its samples
    double position = 0.0;  ///< counts from where the edge began, the median
    double low = 0.0;       ///< a tenth of them is below...
    double high = 0.0;      ///< ... and a tenth above
    unsigned samples = 0;
};

struct EdgeFold {
    std::vector<FoldedPoint> points;
    ResponseRecord run;  ///< the same as one step response, of the median, judged as any other
};

/// Edges that go the same way, with the gains of the last one that does. `forward`: towards higher counts.
/// Places are as wide as the samples permit, but not narrower than a servo tick. Nothing without any. Pure.
[[nodiscard]] std::optional<EdgeFold> foldEdges(std::span<const ResponseRecord> edges, bool forward);

}  // namespace nmc
