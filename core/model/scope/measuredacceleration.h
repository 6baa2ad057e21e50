// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "model/scope/scopesample.h"

namespace nmc {

/// The acceleration of a shaft from its positions: twice the square term of the parabola that fits the last
/// ones best, which is what it was in their middle. Counts are whole, so a shorter time would show little but
/// their rounding. Pure.
class MeasuredAcceleration {
public:
    static constexpr Duration kTime = std::chrono::milliseconds(40);
    static constexpr std::size_t kFewest = 5;  ///< where polls are rarer

    struct Value {
        TimePoint time;
        double value = 0;  ///< counts/s^2
        bool gapBefore = false;
    };
    /// In the order of time.
    [[nodiscard]] std::optional<Value> take(const ScopeSample& sample);

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
