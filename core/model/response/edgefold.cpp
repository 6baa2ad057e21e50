// SPDX-License-Identifier: MIT
#include "model/response/edgefold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/time.h"

namespace nmc {

namespace {

/// Samples per time slot, so that a median means something.
constexpr double kSamplesInPlace = 3.0;

[[nodiscard]] bool isForward(const ResponseTaken& taken) {
    return taken.goal > taken.from;
}

[[nodiscard]] std::vector<const ResponseRecord*> alike(std::span<const ResponseRecord> edges, bool forward) {
    std::vector<const ResponseRecord*> alike;
    for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge)
        if (isForward(edge->taken) == forward &&
            (alike.empty() || edge->taken.gains == alike.front()->taken.gains))
            alike.push_back(&*edge);
    return alike;
}

/// The value below which `part` of the values lie.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

[[nodiscard]] FoldedPoint summed(std::span<const ResponsePoint> points) {
    FoldedPoint folded;
    std::vector<double> positions;
    for (const ResponsePoint& point : points) {
        folded.seconds += point.seconds / static_cast<double>(points.size());
        positions.push_back(point.position);
    }
    std::ranges::sort(positions);
    folded.position = quantile(positions, 0.5);
    folded.low = quantile(positions, 0.1);
    folded.high = quantile(positions, 0.9);
    folded.samples = static_cast<unsigned>(points.size());
    return folded;
}

[[nodiscard]] std::vector<FoldedPoint> laidOver(const std::vector<const ResponseRecord*>& edges) {
    std::vector<ResponsePoint> all;
    for (const ResponseRecord* edge : edges)
        for (const ResponsePoint& point : edge->points)
            all.push_back({point.seconds, point.position - edge->taken.from});
    if (all.empty())
        return {};
    std::ranges::sort(all, {}, &ResponsePoint::seconds);
    const double span = edges.front()->taken.record + toSeconds(kBeforeStep);
    const double width =
        std::max(toSeconds(kServoTick), kSamplesInPlace * span / static_cast<double>(all.size()));
    const auto placeOf = [width](const ResponsePoint& point) {
        return static_cast<std::int64_t>(std::floor(point.seconds / width));
    };
    std::vector<FoldedPoint> folded;
    for (auto from = all.begin(); from != all.end();) {
        const auto to = std::find_if(
            from, all.end(), [&](const ResponsePoint& point) { return placeOf(point) != placeOf(*from); });
        folded.push_back(summed({from, to}));
        from = to;
    }
    return folded;
}

}  // namespace

std::optional<EdgeFold> foldEdges(std::span<const ResponseRecord> edges, bool forward) {
    const std::vector<const ResponseRecord*> found = alike(edges, forward);
    if (found.empty())
        return std::nullopt;
    EdgeFold fold;
    fold.run = *found.front();
    fold.run.points.clear();
    fold.run.pwm.reset();
    fold.points = laidOver(found);
    for (const FoldedPoint& point : fold.points)
        fold.run.points.push_back({point.seconds, fold.run.taken.from + point.position});
    judge(fold.run, fold.run.bandPercent);
    return fold;
}

}  // namespace nmc
