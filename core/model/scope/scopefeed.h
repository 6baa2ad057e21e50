// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "bus/types.h"
#include "model/scope/commandposition.h"
#include "model/scope/scopesample.h"

namespace nmc {

/// Makes samples for the scope of what one module says: adds velocity and calculated error, and marks where
/// data is missing. Fed in the order of the bus. Pure.
class ScopeFeed {
public:
    /// Velocity is the way of this time, or of one poll where polls are rarer.
    static constexpr Duration kVelocityTime = std::chrono::milliseconds(20);
    /// A sample that comes later than this many usual intervals has others missing before it: the same rule
    /// by which a value is called old (interface.md, "Values").
    static constexpr int kMissingAfter = 3;

    void apply(const bus::CommandExecuted& executed) { m_command.apply(executed); }
    /// Nothing of a status without a position or, of a PIC-I/O, without pins.
    [[nodiscard]] std::optional<ScopeSample> take(const bus::Sample& sample);
    /// Whether a command was carried out is not known, or the module has restarted: the command position is
    /// unknown until a command fixes it again.
    void doubt() { m_command.forget(); }
    /// Another host may have set SR, or it was sent and nobody knows whether it was taken.
    void doubtServoRate() { m_command.doubtServoRate(); }
    /// An operation ended before all of it was done: if it left open whether a command was carried out, that
    /// is a doubt too.
    void cancelled() { m_command.cancelled(); }
    /// The next sample does not join on to the last.
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
    std::deque<Place> m_recent;  ///< back to kVelocityTime before the last, and one beyond
    std::optional<Duration> m_interval;
    std::uint8_t m_aux = 0;
    std::uint8_t m_analog = 0;
    // PIC-I/O, as last reported
    std::array<std::uint8_t, 3> m_analogs{};
    std::uint32_t m_counter = 0;
};

}  // namespace nmc
