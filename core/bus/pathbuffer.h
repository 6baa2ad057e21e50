// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "base/time.h"

namespace nmc::bus {

/// What is in the path buffer of one chip, reckoned from the points that it was sent, the number that it last
/// told, and the time since: a point leaves it each period. Pure.
class PathBuffer {
public:
    /// Points of the longest frame, and of the shortest one that goes to a path under way. So many points
    /// more or less show in "points left" although one or two leave meanwhile.
    static constexpr std::size_t kLongestFrame = 7;
    static constexpr std::size_t kShortestFrame = 4;

    PathBuffer(std::size_t points, std::size_t capacity, Duration period)
        : m_points(points), m_capacity(capacity), m_period(period) {}

    /// Points of the next frame; 0: it has all.
    [[nodiscard]] std::size_t frame() const;
    /// From when on there is room for it; at once at first.
    [[nodiscard]] TimePoint roomAt() const;

    /// A frame of so many was carried out.
    void onSent(std::size_t points) { m_sent += points; }
    [[nodiscard]] std::size_t sent() const { return m_sent; }
    [[nodiscard]] bool sentAll() const { return m_sent == m_points; }
    /// It takes points from now on.
    void start(TimePoint latched);

    /// It says that so many are left, latched between these.
    void onReported(std::size_t left, TimePoint from, TimePoint by);
    [[nodiscard]] TimePoint toldAt() const { return m_by; }
    /// Points that have left it for sure.
    [[nodiscard]] std::size_t taken(TimePoint now) const;
    /// It is told that so many are left: whether a frame of `doubtful` points that nobody has answered was
    /// carried out. Nothing when that cannot be told.
    [[nodiscard]] std::optional<bool> carriedOut(std::size_t doubtful, std::size_t left, TimePoint from,
                                                 TimePoint by) const;
    /// When it may have run dry with what it has.
    [[nodiscard]] TimePoint dryAt() const;

private:
    struct Range {
        std::size_t least = 0;
        std::size_t most = 0;
        [[nodiscard]] bool has(std::size_t n) const { return n >= least && n <= most; }
    };
    [[nodiscard]] Range left(std::size_t sent, TimePoint from, TimePoint by) const;

    std::size_t m_points;
    std::size_t m_capacity;
    Duration m_period;
    std::size_t m_sent = 0;
    bool m_running = false;
    std::size_t m_taken = 0;  ///< when it told last
    TimePoint m_from, m_by;   ///< which was latched between these
};

}  // namespace nmc::bus
