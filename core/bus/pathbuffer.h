// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "base/time.h"

namespace nmc::bus {

/// The content of a chip's path buffer, calculated from the points sent, the number last reported, and the
/// time since: one point leaves it per period. Pure.
class PathBuffer {
public:
    /// Number of points in the longest frame, and in the shortest one sent during a path. A difference of
    /// this many points is visible in "points left" although one or two leave in the meantime.
    static constexpr std::size_t kLongestFrame = 7;
    static constexpr std::size_t kShortestFrame = 4;

    PathBuffer(std::size_t points, std::size_t capacity, Duration period)
        : m_points(points), m_capacity(capacity), m_period(period) {}

    /// Number of points in the next frame; 0: all have been sent.
    [[nodiscard]] std::size_t frame() const;
    /// The time from which there is room for the next frame; initially at once.
    [[nodiscard]] TimePoint roomAt() const;

    /// A frame with this many points was carried out.
    void onSent(std::size_t points) { m_sent += points; }
    [[nodiscard]] std::size_t sent() const { return m_sent; }
    [[nodiscard]] bool sentAll() const { return m_sent == m_points; }
    /// The chip takes points from now on.
    void start(TimePoint latched);

    /// The chip reported that `left` points are left, latched between `from` and `by`.
    void onReported(std::size_t left, TimePoint from, TimePoint by);
    [[nodiscard]] TimePoint reportedAt() const { return m_by; }
    /// Number of points that have left the buffer for certain.
    [[nodiscard]] std::size_t taken(TimePoint now) const;
    /// The chip reported that `left` points are left: determines whether a frame of `doubtful` points without
    /// an answer was carried out. Returns nothing if this cannot be determined.
    [[nodiscard]] std::optional<bool> carriedOut(std::size_t doubtful, std::size_t left, TimePoint from,
                                                 TimePoint by) const;
    /// The earliest time at which the buffer may be empty.
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
    std::size_t m_taken = 0;  ///< at the last report
    TimePoint m_from, m_by;   ///< the last report was latched between these
};

}  // namespace nmc::bus
