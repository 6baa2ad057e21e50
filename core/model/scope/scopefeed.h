// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "bus/types.h"
#include "model/scope/commandposition.h"
#include "model/scope/scopesample.h"

namespace nmc {

/// Converts the statuses of one module into samples for the scope: adds velocity and calculated error, and
/// marks missing data. Must be fed in bus order. Pure.
class ScopeFeed {
public:
    /// Velocity is the distance travelled in this time, or in one poll interval where polls are less
    /// frequent.
    static constexpr Duration kVelocityTime = std::chrono::milliseconds(20);
    /// When a sample comes later than this many usual intervals, others are missing before it. A value is
    /// marked as old by the same rule (interface.md, "Values").
    static constexpr int kMissingAfter = 3;

    /// If the command sets the counter, the next sample is not connected with the last: it jumped, and did
    /// not move.
    void apply(const bus::CommandExecuted& executed);
    /// Returns nothing for a status without a position or, from a PIC-I/O, without pins.
    [[nodiscard]] std::optional<ScopeSample> take(const bus::Sample& sample);
    /// Called when it is unknown whether a command was executed, or the module has restarted: the command
    /// position is unknown until a command fixes it again.
    void doubt() { m_command.forget(); }
    /// Called when SR was sent and may not have been accepted.
    void doubtServoRate() { m_command.doubtServoRate(); }
    /// Called when another host may have used the module.
    void attached() { m_command.attached(); }
    /// Called when an operation ended before all of it was done: if it left open whether a command was
    /// executed, the command position is in doubt.
    void cancelled() { m_command.cancelled(); }
    /// The next sample is not connected with the last.
    void breakHere();

private:
    struct Place {
        TimePoint time;
        std::int32_t position;
    };
    [[nodiscard]] ScopeSample takePins(const bus::Sample& sample);
    [[nodiscard]] bool missingBefore(TimePoint time);
    [[nodiscard]] float velocity(const Place& here);
    void setError(ScopeSample& sample, CommandEstimate error);

    CommandPosition m_command;
    std::deque<Place> m_recent;  ///< back to kVelocityTime before the last one, plus one older
    std::optional<Duration> m_interval;
    std::uint8_t m_aux = 0;
    std::uint8_t m_analog = 0;
    // PIC-I/O: last reported values
    std::array<std::uint8_t, 3> m_analogs{};
    std::uint32_t m_counter = 0;
};

}  // namespace nmc
