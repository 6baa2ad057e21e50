// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scope/stretchfigures.h"

namespace nmc {

/// A moment of two signals.
struct XyPoint {
    double x = 0;
    double y = 0;
    bool joined = false;  ///< nothing is missing between the previous point and this one

    bool operator==(const XyPoint&) const = default;
};

/// One signal over another: for each point of `y`, the value of `x` at the same time, on the straight line
/// between its neighbours. Where `x` is unknown there is no point. Both in order of time. Pure.
[[nodiscard]] std::vector<XyPoint> xyCurve(const std::vector<SignalPoint>& x,
                                           const std::vector<SignalPoint>& y);

}  // namespace nmc
