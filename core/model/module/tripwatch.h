// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "protocol/servocommands.h"

namespace nmc {

/// Why a PIC-SERVO probably exceeded its position error limit (DS-V 4.3, 5.2 Set Gain). The chip reports only
/// that it did; the cause is a diagnosis, meant as advice.
enum class TripCause : std::uint8_t {
    Unknown,   ///< no evidence
    Reversed,  ///< it ran away as soon as it was enabled, or moved against its command
    Jam,       ///< it was driven but stood still
    Limit1,    ///< a limit switch closed during the motion
    Limit2,
    OffAtLimit1,  ///< SC: set to switch off at a closed limit (I/O Control)
    OffAtLimit2,
    Behind,  ///< it moved in the right direction, but too slowly
};

/// What is known about a servo at its trip. Counts; positive is forward.
struct TripFacts {
    std::int32_t errorLimit = 0;
    /// The servo was off before and was commanded to hold, and nothing else since.
    bool enabled = false;
    /// Direction of the motion in progress: -1, 0 or 1; also 0 for a motion that did not begin at rest.
    int direction = 0;
    double velocity = 0.0;      ///< maximum of that motion; counts per s
    Duration since{};           ///< from the command to the trip
    std::int64_t moved = 0;     ///< from the command to the trip
    std::int64_t farthest = 0;  ///< forward of the position at the command
    std::int64_t rearmost = 0;  ///< in reverse of the position at the command; negative
    double speed = 0.0;         ///< magnitude, between the last two readings; counts per s
    bool limit1Closed = false;  ///< since the command
    bool limit2Closed = false;
};

/// Diagnoses the probable cause of a trip. Pure.
[[nodiscard]] TripCause diagnose(const TripFacts& facts);

/// Keeps the facts about a servo that diagnose() needs. Part of ModuleState; apply events in order. Pure.
class TripWatch {
public:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
        bool limit1 = false;  ///< active; only for a pin that is an input
        bool limit2 = false;
    };
    struct Command {
        TimePoint time;
        bool fromOff = false;   ///< the servo was off before
        bool fromRest = false;  ///< the command velocity was 0 before
        int direction = 0;
        double velocity = 0.0;  ///< counts per s, a magnitude
    };

    void apply(const Command& command);
    /// Call for each status.
    void apply(const Reading& reading);
    /// The position was set: earlier readings no longer count.
    void forget() { *this = {}; }
    /// `off`: the status that showed the trip, not yet applied. Empty before the first command of this
    /// connection.
    [[nodiscard]] std::optional<TripFacts> facts(const Reading& off, std::int32_t errorLimit) const;

private:
    std::optional<Command> m_command;
    std::optional<Reading> m_first;  ///< at the command
    std::optional<Reading> m_last;
    std::int64_t m_farthest = 0;
    std::int64_t m_rearmost = 0;
};

}  // namespace nmc
