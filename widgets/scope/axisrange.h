// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace nmc {

/// An axis range that does not jump: it grows at once, in whole divisions, and shrinks only when the visible
/// values have spanned much less for a while.
class AxisRange {
public:
    struct Range {
        double min = -1;
        double max = 1;
        double step = 1;  ///< one division: 1, 2 or 5 times a power of ten
        bool operator==(const Range&) const = default;
    };
    /// In counts, so that rounding noise does not fill the whole strip.
    static constexpr double kSmallestSpan = 4.0;

    /// Fits the range to the values that are visible at the time `seconds` (of any origin). It never spans
    /// less than `smallest`.
    const Range& fit(double low, double high, double seconds, double smallest = kSmallestSpan);
    /// The last range, which is kept while nothing is visible.
    [[nodiscard]] const Range& range() const { return m_range; }
    void reset();

    /// The smallest span of an axis at these values: on a narrower one, rounding would move them by whole
    /// divisions.
    [[nodiscard]] static double narrowest(double low, double high);
    /// The smallest range of whole divisions around low..high, with about `divisions` of them. A single value
    /// with no `smallest` span is in the middle of a span of 2.
    [[nodiscard]] static Range around(double low, double high, double smallest = kSmallestSpan,
                                      int divisions = 4);

private:
    Range m_range;
    bool m_set = false;
    std::optional<double> m_smallSince;  ///< s, since when the values have spanned much less
};

}  // namespace nmc
