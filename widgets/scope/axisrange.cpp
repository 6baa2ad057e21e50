// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/axisrange.h"

#include <algorithm>
#include <cmath>

namespace nmc {

namespace {
constexpr double kPatience = 2.0;      ///< s before a range shrinks
constexpr double kMuchSmaller = 0.45;  ///< of the present range
constexpr double kSmallestSpan = 4.0;  ///< counts: rounding noise is not worth the whole strip
}  // namespace

AxisRange::Range AxisRange::around(double low, double high, int divisions) {
    const double missing = kSmallestSpan - (high - low);
    if (missing > 0) {
        low -= missing / 2;
        high += missing / 2;
    }
    const double rough = (high - low) / divisions;
    const double magnitude = std::pow(10.0, std::floor(std::log10(rough)));
    const double ratio = rough / magnitude;
    const double step = std::max(1.0, (ratio <= 1.001   ? 1
                                       : ratio <= 2.001 ? 2
                                       : ratio <= 5.001 ? 5
                                                        : 10) *
                                          magnitude);
    return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

const AxisRange::Range& AxisRange::fit(double low, double high, double seconds) {
    if (!m_set) {
        m_set = true;
        m_range = around(low, high);
        return m_range;
    }
    if (low < m_range.min || high > m_range.max) {
        // A tenth of room beyond, so that a ramp does not change the axis on every frame.
        const double room = 0.1 * (high - low);
        m_range = around(low < m_range.min ? low - room : low, high > m_range.max ? high + room : high);
        m_small = false;
        return m_range;
    }
    const Range tight = around(low, high);
    if (tight.max - tight.min > kMuchSmaller * (m_range.max - m_range.min)) {
        m_small = false;
        return m_range;
    }
    if (!m_small) {
        m_small = true;
        m_smallSince = seconds;
    } else if (seconds - m_smallSince > kPatience) {
        m_range = tight;
        m_small = false;
    }
    return m_range;
}

void AxisRange::reset() {
    *this = AxisRange();
}

}  // namespace nmc
