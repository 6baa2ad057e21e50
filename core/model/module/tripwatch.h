// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "protocol/servocommands.h"

namespace nmc {

/// Why a PIC-SERVO probably exceeded its position error limit (DS-V 4.3, 5.2 Set Gain). What the chip says is
/// only that it did; the rest is a judgement, made to be advice.
enum class TripCause : std::uint8_t {
    Unknown,   ///< nothing that tells
    Reversed,  ///< it ran away as soon as it was enabled, or against what it was told
    Jam,       ///< it was driven and stood
    Limit1,    ///< a limit switch closed on the way
    Limit2,
    OffAtLimit1,  ///< SC: told to switch off at a closed limit (I/O Control)
    OffAtLimit2,
    Behind,  ///< it went the right way, too slowly
};

/// What is known of a servo at its trip. Counts; positive is forward.
struct TripFacts {
    std::int32_t errorLimit = 0;
    /// It was off before, and was told to hold: since then it has only been that.
    bool enabled = false;
    /// Where the motion that was under way was to go: -1, 0 or 1; 0 for one that did not begin at rest, too.
    int direction = 0;
    double velocity = 0.0;      ///< of that motion, the most it was to have; counts per s
    Duration since{};           ///< from the command to the trip
    std::int64_t moved = 0;     ///< from the command to the trip
    std::int64_t farthest = 0;  ///< forward of where it was at the command
    std::int64_t rearmost = 0;  ///< in reverse of that, negative
    double speed = 0.0;         ///< between the last two readings, counts per s; its magnitude
    bool limit1Closed = false;  ///< since the command
    bool limit2Closed = false;
};

/// Pure.
[[nodiscard]] TripCause diagnose(const TripFacts& facts);

/// Keeps of a servo what diagnose() will want to know of it. Part of ModuleState; told in the order of
/// events. Pure.
class TripWatch {
public:
    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
        bool limit1 = false;  ///< active, of an input
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
    /// Of every status.
    void apply(const Reading& reading);
    /// Its position was set: what was seen before does not count.
    void forget() { *this = {}; }
    /// `off`: the status that told of the trip, not applied yet. Nothing before a command of this connection.
    [[nodiscard]] std::optional<TripFacts> facts(const Reading& off, std::int32_t errorLimit) const;

private:
    std::optional<Command> m_command;
    std::optional<Reading> m_first;  ///< of the command
    std::optional<Reading> m_last;
    std::int64_t m_farthest = 0;
    std::int64_t m_rearmost = 0;
};

}  // namespace nmc
