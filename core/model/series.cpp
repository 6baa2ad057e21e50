// SPDX-License-Identifier: MIT
#include "model/series.h"

#include <algorithm>
#include <cassert>

namespace nmc {

namespace {

/// The points of one pixel column that change the picture: first, lowest, highest, last, in order of time.
class Column {
public:
    void add(const SeriesPoint& point) {
        if (m_count == 0)
            m_first = m_low = m_high = point;
        if (point.value < m_low.value)
            m_low = point;
        if (point.value > m_high.value)
            m_high = point;
        m_last = point;
        ++m_count;
    }
    void flushInto(Series::Segment& segment) {
        if (m_count == 0)
            return;
        const bool lowFirst = m_low.time <= m_high.time;
        for (const SeriesPoint& point :
             {m_first, lowFirst ? m_low : m_high, lowFirst ? m_high : m_low, m_last})
            if (segment.empty() || segment.back().time < point.time)
                segment.push_back(point);
        m_count = 0;
    }

private:
    SeriesPoint m_first, m_low, m_high, m_last;
    std::size_t m_count = 0;
};

}  // namespace

void Series::append(TimePoint time, double value) {
    assert(m_points.empty() || time >= m_points.back().point.time);
    if (m_points.size() == m_capacity)
        m_points.pop_front();
    m_points.push_back({{time, value}, m_broken});
    m_broken = false;
}

void Series::breakHere() {
    m_broken = true;
}

void Series::clear() {
    m_points.clear();
    m_broken = true;
}

std::optional<SeriesPoint> Series::last() const {
    if (m_points.empty())
        return std::nullopt;
    return m_points.back().point;
}

std::vector<Series::Segment> Series::window(TimePoint from, TimePoint to, std::size_t columns) const {
    std::vector<Segment> segments;
    if (m_points.empty() || columns == 0 || to <= from)
        return segments;
    const auto before = [](const Entry& entry, TimePoint t) { return entry.point.time < t; };
    const auto after = [](TimePoint t, const Entry& entry) { return t < entry.point.time; };
    auto first = std::lower_bound(m_points.begin(), m_points.end(), from, before);
    auto end = std::upper_bound(first, m_points.end(), to, after);
    if (first != m_points.begin())
        --first;
    if (end != m_points.end())
        ++end;

    // Columns are anchored on absolute time: a window that scrolls keeps its columns, and nothing shimmers.
    const std::int64_t width =
        std::max<std::int64_t>(1, (to - from).count() / static_cast<std::int64_t>(columns));
    Column column;
    std::int64_t present = 0;
    for (auto entry = first; entry != end; ++entry) {
        const std::int64_t number = entry->point.time.time_since_epoch().count() / width;
        const bool newSegment = segments.empty() || entry->startsSegment;
        if (!segments.empty() && (newSegment || number != present))
            column.flushInto(segments.back());
        if (newSegment)
            segments.emplace_back();
        present = number;
        column.add(entry->point);
    }
    if (!segments.empty())
        column.flushInto(segments.back());
    return segments;
}

}  // namespace nmc
