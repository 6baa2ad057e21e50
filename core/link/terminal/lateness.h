// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/time.h"

namespace nmc {

/// How late things have happened, in steps of 10 us up to 10 ms: small, and adding to it costs nothing.
class Lateness {
public:
    void add(Duration late);
    /// The least time within which 99 of 100 were, to the next step; 0 when there was nothing.
    [[nodiscard]] Duration percentile99() const;
    [[nodiscard]] Duration largest() const { return m_largest; }

private:
    static constexpr Duration kStep = std::chrono::microseconds(10);

    std::array<std::uint32_t, 1'001> m_steps{};  ///< the last one is everything beyond
    std::uint64_t m_count = 0;
    Duration m_largest{};
};

/// When this process was not let run while it should have been: whatever its host did or missed in such a
/// time is the machine's fault.
class StallWatch {
public:
    static constexpr Duration kStall = std::chrono::milliseconds(20);

    /// It runs, which it should do far more often than every kStall.
    void runs(TimePoint now);
    [[nodiscard]] std::uint64_t count() const { return m_count; }
    [[nodiscard]] Duration longest() const { return m_longest; }

private:
    std::optional<TimePoint> m_last;
    std::uint64_t m_count = 0;
    Duration m_longest{};
};

/// When to say that a simulation cannot keep up: at once, every 5 seconds while it lasts, and when it is
/// over.
class LagReport {
public:
    /// `behind`: how far simulated time is behind the time it should have. A sentence to be said now, if any.
    [[nodiscard]] std::optional<std::string> sentence(Duration behind, TimePoint now);

private:
    std::optional<TimePoint> m_said;
    bool m_isBehind = false;
};

}  // namespace nmc
