// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/axisrange.h"

#include <algorithm>
#include <cmath>

#include "widgets/scope/timewindow.h"

namespace nmc {

namespace {
constexpr double kShrinkDelay = 2.0;   ///< s before a range shrinks
constexpr double kMuchSmaller = 0.45;  ///< fraction of the present range
}  // namespace

double AxisRange::narrowest(double low, double high) {
    return 1e-12 * std::max(std::abs(low), std::abs(high));
}

AxisRange::Range AxisRange::around(double low, double high, double smallest, int divisions) {
    if (high <= low && smallest <= 0)
        smallest = 2;  // a single value has an axis, too
    const double missing = std::max(smallest, narrowest(low, high)) - (high - low);
    if (missing > 0) {
        low -= missing / 2;
        high += missing / 2;
    }
    const double step = TimeWindow::nice((high - low) / divisions);
    return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

const AxisRange::Range& AxisRange::fit(double low, double high, double seconds, double smallest) {
    if (!m_set) {
        m_set = true;
        m_range = around(low, high, smallest);
        return m_range;
    }
    if (low < m_range.min || high > m_range.max) {
        // Leaves a tenth free, so that a ramp does not change the axis in every frame.
        const double room = 0.1 * (high - low);
        m_range =
            around(low < m_range.min ? low - room : low, high > m_range.max ? high + room : high, smallest);
        m_smallSince.reset();
        return m_range;
    }
    const Range tight = around(low, high, smallest);
    if (tight.max - tight.min > kMuchSmaller * (m_range.max - m_range.min)) {
        m_smallSince.reset();
    } else if (!m_smallSince) {
        m_smallSince = seconds;
    } else if (seconds - *m_smallSince > kShrinkDelay) {
        m_range = tight;
        m_smallSince.reset();
    }
    return m_range;
}

void AxisRange::reset() {
    *this = AxisRange();
}

}  // namespace nmc
