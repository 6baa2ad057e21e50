// SPDX-License-Identifier: MIT
#include "model/response/edgefold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/time.h"

namespace nmc {

namespace {

/// In a place, so that a median means something.
constexpr double kSamplesInPlace = 3.0;

[[nodiscard]] bool isForward(const StepTaken& taken) {
    return taken.goal > taken.from;
}

[[nodiscard]] std::vector<const StepRun*> alike(std::span<const StepRun> edges, bool forward) {
    std::vector<const StepRun*> alike;
    for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge)
        if (isForward(edge->taken) == forward &&
            (alike.empty() || edge->taken.gains == alike.front()->taken.gains))
            alike.push_back(&*edge);
    return alike;
}

/// `part` of them are below it.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

[[nodiscard]] FoldedPoint summed(std::span<const StepPoint> points) {
    FoldedPoint folded;
    std::vector<double> positions;
    for (const StepPoint& point : points) {
        folded.seconds += point.seconds / static_cast<double>(points.size());
        positions.push_back(point.position);
    }
    std::sort(positions.begin(), positions.end());
    folded.position = quantile(positions, 0.5);
    folded.low = quantile(positions, 0.1);
    folded.high = quantile(positions, 0.9);
    folded.samples = static_cast<unsigned>(points.size());
    return folded;
}

}  // namespace

std::vector<FoldedPoint> foldEdges(std::span<const StepRun> edges, bool forward) {
    std::vector<StepPoint> all;
    double width = toSeconds(kServoTick);
    double span = 0.0;
    for (const StepRun* edge : alike(edges, forward)) {
        span = edge->taken.record + toSeconds(kBeforeStep);
        for (const StepPoint& point : edge->points)
            all.push_back({point.seconds, point.position - edge->taken.from});
    }
    if (all.empty())
        return {};
    std::sort(all.begin(), all.end(),
              [](const StepPoint& a, const StepPoint& b) { return a.seconds < b.seconds; });
    width = std::max(width, kSamplesInPlace * span / static_cast<double>(all.size()));
    const auto placeOf = [width](const StepPoint& point) {
        return static_cast<std::int64_t>(std::floor(point.seconds / width));
    };
    std::vector<FoldedPoint> folded;
    for (auto from = all.begin(); from != all.end();) {
        const auto to = std::find_if(
            from, all.end(), [&](const StepPoint& point) { return placeOf(point) != placeOf(*from); });
        folded.push_back(summed({from, to}));
        from = to;
    }
    return folded;
}

std::optional<StepRun> foldedRun(std::span<const StepRun> edges, bool forward) {
    const std::vector<const StepRun*> found = alike(edges, forward);
    if (found.empty())
        return std::nullopt;
    StepRun run = *found.front();
    run.points.clear();
    for (const FoldedPoint& point : foldEdges(edges, forward))
        run.points.push_back({point.seconds, run.taken.from + point.position});
    run.pwm.reset();
    setBand(run, run.bandPercent);
    return run;
}

}  // namespace nmc
