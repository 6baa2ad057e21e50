// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "base/time.h"

namespace nmc {

struct SeriesPoint {
    TimePoint time;
    double value = 0.0;
};

/// A signal over time with gaps, bounded in memory: the oldest points make room. Times must not go back.
class Series {
public:
    explicit Series(std::size_t capacity = 120'000) : m_capacity(capacity) {}

    void append(TimePoint time, double value);
    /// The next point does not connect to the last: data is missing in between.
    void breakHere();
    void clear();

    [[nodiscard]] bool empty() const { return m_points.empty(); }
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    [[nodiscard]] std::optional<SeriesPoint> last() const;

    using Segment = std::vector<SeriesPoint>;
    /// What a plot of [from, to] that is `columns` pixels wide has to draw: per gapless segment at most the
    /// first, lowest, highest and last point of every column, one point beyond each end included.
    [[nodiscard]] std::vector<Segment> window(TimePoint from, TimePoint to, std::size_t columns) const;

private:
    struct Entry {
        SeriesPoint point;
        bool startsSegment;
    };
    std::deque<Entry> m_points;
    std::size_t m_capacity;
    bool m_broken = true;
};

/// The signals of one module that the scope draws. Units: counts.
struct ModuleHistory {
    Series position;
    Series command;  ///< calculated command position (scope.md)
    Series error;    ///< calculated: command - position
};

}  // namespace nmc
