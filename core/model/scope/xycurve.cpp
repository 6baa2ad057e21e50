// SPDX-License-Identifier: MIT
#include "model/scope/xycurve.h"

#include <cstddef>

namespace nmc {

std::vector<XyPoint> xyCurve(const std::vector<SignalPoint>& x, const std::vector<SignalPoint>& y) {
    std::vector<XyPoint> curve;
    bool joined = false;
    std::size_t after = 0;  // first point of x that is not before that of y
    for (const SignalPoint& point : y) {
        const std::size_t before = after;
        while (after < x.size() && x[after].seconds < point.seconds)
            ++after;
        if (after == x.size())
            break;
        joined = joined && point.joined;
        for (std::size_t i = before + 1; i <= after; ++i)
            joined = joined && x[i].joined;
        const SignalPoint& next = x[after];
        if (next.seconds == point.seconds) {
            curve.push_back({next.value, point.value, joined});
        } else if (after > 0 && next.joined) {
            const SignalPoint& last = x[after - 1];
            const double share = (point.seconds - last.seconds) / (next.seconds - last.seconds);
            curve.push_back({last.value + share * (next.value - last.value), point.value, joined});
        } else {
            joined = false;
            continue;
        }
        joined = true;
    }
    return curve;
}

}  // namespace nmc
