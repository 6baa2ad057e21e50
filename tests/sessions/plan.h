// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/sessions/rig.h"

/// Sessions made from a seed: the same seed gives the same session everywhere.
namespace nmc::test {

/// How it comes about that there is something to stop.
enum class Prologue : std::uint8_t {
    Fresh,       ///< nothing has been requested yet
    Running,     ///< connected, all motors on and in motion
    LeftBehind,  ///< another program has left the chain running, at a rate of its own
    Holding,     ///< connected, all motors on, but none in motion
    Nobody,      ///< like Running, and then nothing answers while the chain is searched for again
    InVain,      ///< like Nobody, but the search has ended
    Lost,        ///< like Running, and then nothing answers for so long that the link is given up
};

enum class ActKind : std::uint8_t {
    Connect,
    Restart,
    ChangeRate,
    Distrust,
    PutIntoGroup,
    StartGroup,
    HoldAndRelease,
    HoldAndLapse,
    Move,
    Velocity,
    Pwm,
    Enable,
    MotorOff,
    PowerCycle,
    PowerCycleAll,
    Strike,  ///< see the struct
    Wait,
};

/// A fault that lasts for a time, in the notation of simulator.md.
struct Strike {
    std::string_view line;
    bool deafens = false;  ///< commands may not arrive
    bool ofOneModule = false;
    std::string_view too{};  ///< another fault at the same time
};

struct Act {
    ActKind kind = ActKind::Wait;
    Strike strike{};
    std::uint8_t module = 0;
    unsigned value = 0;  ///< 0..255: speed, distance, rate or place in the group
    Duration time{};     ///< duration, if it has one
    Duration pause{};    ///< until the next one
};

/// What is requested while the stop runs.
enum class Follow : std::uint8_t { Nothing, StopAgain, Connect, Restart, Distrust };

struct Plan {
    std::uint64_t seed = 0;
    World world;
    Prologue prologue = Prologue::Fresh;
    std::uint32_t formerBaud = 19'200;  ///< rate of the earlier program
    std::vector<Act> acts;
    std::uint64_t bytes = 0;  ///< bytes that cross the wire between the last act and the stop
    bool stops = true;
    Follow follow = Follow::Nothing;
    std::uint64_t followBytes = 0;  ///< bytes between the stop and `follow`
};

[[nodiscard]] Plan makePlan(std::uint64_t seed);
/// The same plan on a read-only connection to what another program has left behind; a stop is requested in
/// every third.
[[nodiscard]] Plan makeReadOnlyPlan(std::uint64_t seed);
[[nodiscard]] std::string toText(const Plan& plan);

/// Carries out the plan; `rig` must be made of plan.world. Then everything is allowed to come to its end.
void carryOut(const Plan& plan, Rig& rig);

}  // namespace nmc::test
