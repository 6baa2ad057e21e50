// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/sessions/rig.h"

/// Sessions made from a seed: the same seed is the same session, everywhere.
namespace nmc::test {

/// How it comes that there is somebody to stop.
enum class Prologue : std::uint8_t {
    Fresh,       ///< nothing has been asked for yet
    Running,     ///< connected, all motors on, most of them in motion
    LeftBehind,  ///< another program has left the chain like that, at a rate of its own
    Holding,     ///< like Running, but nothing moves
    Nobody,      ///< like Running, and then nobody answers while the chain is looked for again
    InVain,      ///< like Nobody, and the search has ended
    Lost,        ///< like Running, and then nobody has answered for so long that the link is given up
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
    Strike,  ///< see below
    Wait,
};

/// Something goes wrong for a time, in the words of simulator.md.
struct Strike {
    std::string_view line;
    bool deafens = false;  ///< commands may not arrive
    bool ofOneModule = false;
    std::string_view too{};  ///< another one at the same time
};

struct Act {
    ActKind kind = ActKind::Wait;
    Strike strike{};
    std::uint8_t module = 0;
    unsigned value = 0;  ///< 0..255: how fast, how far, how often
    Duration time{};     ///< how long it lasts, where it lasts
    Duration pause{};    ///< until the next one
};

/// What is asked for while the stop runs.
enum class Follow : std::uint8_t { Nothing, StopAgain, Connect, Restart, Distrust };

struct Plan {
    std::uint64_t seed = 0;
    World world;
    Prologue prologue = Prologue::Fresh;
    std::uint32_t formerBaud = 19'200;  ///< of the program before
    std::vector<Act> acts;
    std::uint64_t bytes = 0;  ///< that cross the wire between the last act and the stop
    bool stops = true;
    Follow follow = Follow::Nothing;
    std::uint64_t followBytes = 0;  ///< between the stop and that
};

[[nodiscard]] Plan makePlan(std::uint64_t seed);
/// The same, but that the operator finds what another program has left behind, and only looks; a stop is
/// asked for in every third.
[[nodiscard]] Plan makeReadOnlyPlan(std::uint64_t seed);
[[nodiscard]] std::string toText(const Plan& plan);

/// Carries it out; `rig` is made of plan.world. Then everything is let come to its end.
void carryOut(const Plan& plan, Rig& rig);

}  // namespace nmc::test
