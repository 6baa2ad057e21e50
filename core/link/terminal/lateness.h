// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/time.h"

namespace nmc {

/// A histogram of delays in steps of 10 us up to 10 ms: small, and cheap to update.
class Lateness {
public:
    void add(Duration late);
    /// The smallest step within which 99 of 100 delays were; 0 when there were none.
    [[nodiscard]] Duration percentile99() const;
    [[nodiscard]] Duration largest() const { return m_largest; }

private:
    static constexpr Duration kStep = std::chrono::microseconds(10);

    std::array<std::uint32_t, 1'001> m_steps{};  ///< the last one counts everything beyond
    std::uint64_t m_count = 0;
    Duration m_largest{};
};

/// Detects when this process was not scheduled although it should have been: whatever its host did or missed
/// in such a period is the machine's fault.
class StallWatch {
public:
    static constexpr Duration kStall = std::chrono::milliseconds(20);

    /// Reports that the process runs, which should happen far more often than every kStall.
    void runs(TimePoint now);
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    [[nodiscard]] Duration longest() const { return m_longest; }

private:
    std::optional<TimePoint> m_last;
    std::uint64_t m_count = 0;
    Duration m_longest{};
};

/// Decides when to report that a simulation cannot keep up: at once, every 5 seconds while it lasts, and when
/// it is over.
class LagReport {
public:
    /// `behind`: how far simulated time lags behind its due time. Returns a sentence to be output now, if
    /// any.
    [[nodiscard]] std::optional<std::string> sentence(Duration behind, TimePoint now);

private:
    std::optional<TimePoint> m_said;
    bool m_isBehind = false;
};

}  // namespace nmc
