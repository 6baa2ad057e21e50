// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "model/scope/scopesample.h"

namespace nmc {

/// The acceleration of a shaft from its positions: twice the quadratic coefficient of the parabola that best
/// fits the last positions, which is the acceleration in their middle. Counts are whole numbers, so over a
/// shorter time the result would show little but rounding. Pure.
class MeasuredAcceleration {
public:
    static constexpr Duration kTime = std::chrono::milliseconds(40);
    static constexpr std::size_t kFewest = 5;  ///< minimum where polls are less frequent

    /// Counts/s^2. Samples must be in order of time.
    [[nodiscard]] std::optional<ScopeSample> take(const ScopeSample& sample);

private:
    struct Place {
        TimePoint time;
        double position;
    };
    [[nodiscard]] double fitted(TimePoint middle) const;

    std::deque<Place> m_places;
    bool m_gap = true;
};

}  // namespace nmc
