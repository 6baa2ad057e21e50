// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "model/scope/scopesample.h"

namespace nmc {

/// The frequency of a PIC-I/O's counter or timer after its prescaler, computed from the counts of the last
/// 100 ms, or of two replies where polls are less frequent. Pure.
class CountRate {
public:
    static constexpr Duration kTime = std::chrono::milliseconds(100);
    /// More than the timer's 5.0 MHz is not counting; the counter was cleared (docs/family.md).
    static constexpr double kMax = 5.5e6;

    /// Counts/s. Samples must be in order of time; one without a counter value of its own yields nothing.
    [[nodiscard]] std::optional<ScopeSample> take(const ScopeSample& sample);

private:
    struct Reading {
        TimePoint time;
        std::uint32_t count;
    };
    std::deque<Reading> m_readings;  ///< back to kTime before the last one, plus one older
    bool m_gap = true;
};

}  // namespace nmc
